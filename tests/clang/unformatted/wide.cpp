// The control of the test `format`: a line that clang-format would break.
int   sum( int a,int b ) { return a+b; }
