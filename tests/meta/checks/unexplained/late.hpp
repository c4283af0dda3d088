// The control of openings.cmake: #pragma once is not the first line.
#pragma once

struct Late {};
