// Correct code, which every check must accept.
int right() { return 1; }
