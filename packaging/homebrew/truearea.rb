# Formula for the command line; the release fills in version and checksum.
class Truearea < Formula
  desc "How much of two rough surfaces really touches, and which scales decide it"
  homepage "https://example.org/truearea"
  url "https://example.org/truearea/archive/refs/tags/v0.1.0.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license any_of: ["MIT", "Apache-2.0"]

  depends_on "rust" => :build

  def install
    system "cargo", "install", *std_cargo_args(path: "crates/apps/cli")
    system bin/"truearea", "man", "--out", man1
    generate_completions_from_executable(bin/"truearea", "completions")
  end

  test do
    assert_match "touches", shell_output("#{bin}/truearea report builtin:uncd-measured --material diamond --pressure 1MPa --out found")
  end
end
