//! The report in Chromium: it prints, and asks the network for nothing.
//!
//! Ignored by default, since it needs a browser: `cargo test --workspace --test browser -- --ignored`.

mod support;

use std::process::Command;

use support::Bench;

/// Runs Chromium without a window on a page of the bench.
fn browse(bench: &Bench, options: &[&str]) -> String {
    let page = format!("file://{}", bench.path("r/report.html").display());
    let profile = format!("--user-data-dir={}", bench.path("profile").display());
    let quiet =
        ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-sync"];
    let ran = Command::new("chromium")
        .args(quiet)
        .args(["--disable-component-update", "--no-first-run", "--no-pdf-header-footer", &profile])
        .args(options)
        .arg(page)
        .output()
        .expect("chromium is installed");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    String::from_utf8_lossy(&ran.stdout).into_owned()
}

fn with_report() -> Bench {
    let bench = Bench::new();
    let options = "report builtin:uncd-measured --material diamond --yield-strength 1.8GPa --pressure 5.4MPa --pressure 54MPa \
                   --out r";
    bench.run(&options.split(' ').collect::<Vec<_>>()).ok();
    bench
}

#[test]
#[ignore = "needs Chromium"]
fn a_report_prints_with_its_details_open() {
    let bench = with_report();
    browse(&bench, &[&format!("--print-to-pdf={}", bench.path("r.pdf").display())]);
    let pdf = std::fs::read(bench.path("r.pdf")).unwrap();
    let pages = String::from_utf8_lossy(&pdf).matches("/Type /Page\n").count();
    assert!((3..=12).contains(&pages), "two pages and an appendix, not {pages}");
}

#[test]
#[ignore = "needs Chromium"]
fn a_report_in_a_browser_sends_no_request_and_is_not_changed() {
    let bench = with_report();
    let log = bench.path("net.json");
    let shown = browse(&bench, &[&format!("--log-net-log={}", log.display()), "--dump-dom"]);
    assert!(shown.contains("touches") && !shown.contains("<script"));
    let page = bench.read("r/report.html");
    let elements = |page: &str| page.matches("<td").count();
    assert_eq!(elements(&shown), elements(&page));
    let log = std::fs::read_to_string(log).unwrap();
    assert!(
        !log.contains("report.html?") && !log.contains("\"initiator\":\"file://"),
        "a request from the page"
    );
}
