"""Control laws, one file each. The file's name is the law's name on the command line and in the cockpit."""
