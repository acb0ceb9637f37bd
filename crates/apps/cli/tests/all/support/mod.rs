//! Running the binary in a folder of its own.

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use tempfile::TempDir;

/// The options that name the paper's diamond.
pub const DIAMOND: [&str; 6] =
    ["--youngs-modulus", "463GPa", "--poisson-ratio", "0.2", "--yield-strength", "1.8GPa"];

/// An empty folder in which commands run.
pub struct Bench {
    folder: TempDir,
}

/// The output and the exit status of a command.
#[derive(Debug)]
pub struct Ran {
    pub status: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Bench {
    pub fn new() -> Self {
        Bench { folder: TempDir::new().unwrap() }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> &Self {
        std::fs::write(self.path(name), content).unwrap();
        self
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    /// The names of all files, sorted.
    pub fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    pub fn run(&self, args: &[&str]) -> Ran {
        self.run_with_input(args, "")
    }

    /// Runs with an environment variable set.
    pub fn run_with_env(&self, args: &[&str], name: &str, value: &str) -> Ran {
        self.spawn(Command::new(env!("CARGO_BIN_EXE_truearea")).env(name, value), args, "")
    }

    pub fn run_with_input(&self, args: &[&str], input: &str) -> Ran {
        self.spawn(&mut Command::new(env!("CARGO_BIN_EXE_truearea")), args, input)
    }

    /// Runs on a terminal at which somebody types these lines; returns what it shows there.
    #[cfg(unix)]
    pub fn run_on_terminal(&self, args: &[&str], typed: &str) -> Ran {
        use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
        use std::fs::File;
        use std::io::Read;

        let screen = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&screen).unwrap();
        unlockpt(&screen).unwrap();
        let name = ptsname(&screen, Vec::new()).unwrap().into_string().unwrap();
        let terminal = File::options().read(true).write(true).open(name).unwrap();
        let mut screen = File::from(screen);
        screen.write_all(typed.as_bytes()).unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_truearea"))
            .args(args)
            .current_dir(self.folder.path())
            .stdin(terminal.try_clone().unwrap())
            .stderr(terminal)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let reader = std::thread::spawn(move || {
            // A terminal that nobody holds any more ends with an error.
            let mut shown = Vec::new();
            let _ = screen.read_to_end(&mut shown);
            String::from_utf8_lossy(&shown).into_owned()
        });
        let mut stdout = String::new();
        child.stdout.take().unwrap().read_to_string(&mut stdout).unwrap();
        let status = child.wait().unwrap().code().unwrap_or(-1);
        Ran { status, stdout, stderr: reader.join().unwrap() }
    }

    fn spawn(&self, command: &mut Command, args: &[&str], input: &str) -> Ran {
        let mut child = command
            .args(args)
            .current_dir(self.folder.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // A command that fails before it reads leaves the pipe closed.
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        let output = child.wait_with_output().unwrap();
        Ran {
            status: output.status.code().unwrap(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Ran {
    /// Asserts success, and yields stdout.
    #[track_caller]
    pub fn ok(self) -> String {
        assert_eq!(self.status, 0, "{}", self.stderr);
        self.stdout
    }

    /// Asserts that bad input was refused and nothing printed, and yields the message.
    #[track_caller]
    pub fn refused(self) -> String {
        assert_eq!((self.status, self.stdout.as_str()), (2, ""), "{}", self.stderr);
        self.stderr
    }

    /// Asserts that bad input was refused, nothing printed, and these flags, files and values named.
    ///
    /// Whole messages are in the snapshot of `messages.rs`.
    #[track_caller]
    pub fn refused_naming(self, names: &[&str]) {
        assert_names(&self.refused(), names);
    }

    /// The lines on stderr that have all of these words.
    pub fn remarks(&self, words: &[&str]) -> Vec<&str> {
        lines_with(&self.stderr, words)
    }

    /// Asserts success and one remark with these words, and yields stdout.
    #[track_caller]
    pub fn ok_remarking(self, words: &[&str]) -> String {
        assert_eq!(self.remarks(words).len(), 1, "{words:?} in {}", self.stderr);
        self.ok()
    }
}

/// Asserts that a text has all of these words.
#[track_caller]
pub fn assert_names(text: &str, words: &[&str]) {
    for word in words {
        assert!(text.contains(word), "{word} is not in {text}");
    }
}

/// The lines of a text that have all of these words.
pub fn lines_with<'t>(text: &'t str, words: &[&str]) -> Vec<&'t str> {
    text.lines().filter(|line| words.iter().all(|word| line.contains(word))).collect()
}

/// The cells of a CSV column.
pub fn column<'t>(table: &'t str, name: &str) -> Vec<&'t str> {
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let at = lines.next().unwrap().split(',').position(|column| column == name).unwrap();
    lines.map(|line| line.split(',').nth(at).unwrap()).collect()
}

/// The numbers in a CSV column.
pub fn numbers(table: &str, name: &str) -> Vec<f64> {
    column(table, name).iter().map(|cell| cell.parse().unwrap()).collect()
}
