"""The kinds of plots, one file each: from results to a sheet."""
