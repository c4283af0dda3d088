// Chooses the primitive test of a configuration.
#include "model/unit/tri/tri_test.hpp"

#include <cassert>

#include "model/unit/tri/baselines/moller.hpp"
#include "model/unit/tri/sheared.hpp"
#include "model/unit/tri/tri.hpp"
#include "model/unit/tri/baselines/truncated.hpp"
#include "model/unit/tri/baselines/unit24.hpp"
#include "model/unit/tri/baselines/woop.hpp"

namespace rayclock {

TriTest* tri_test_of(const Config& config) {
    switch (config.test()) {
        case PrimitiveTest::exact: return tri_test;
        case PrimitiveTest::sheared: return sheared_test;
        case PrimitiveTest::unit24: return unit24_test;
        case PrimitiveTest::moller: return moller_test;
        case PrimitiveTest::woop: return woop_test;
        case PrimitiveTest::truncated: return truncated_test;
    }
    assert(false && "check_config lets no other value pass");
    return tri_test;
}

}   // namespace rayclock
