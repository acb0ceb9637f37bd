"""The command line ``truearea``; the package ``truearea`` is for use in Python."""
