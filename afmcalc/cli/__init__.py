"""The command line: read arguments, call, render, exit code."""
