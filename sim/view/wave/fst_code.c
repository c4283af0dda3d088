/* GTKWave's code with our own writing. */
#include "fst_config.h"
#include "sim/view/wave/fst_io.h"

#define FST_CONFIG_INCLUDE "fst_config.h"
#include "fstapi.c"
