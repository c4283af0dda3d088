// No fault of the model is awake. A program that holds such faults brings its own (link_with_faults).
int rc_fault = 0;
