// A ray's walk through the tree. Included inside a namespace, once per instruction set. tree_walk.hpp has it
// for the baseline.

/// The course of one ray, step by step, or as a whole by run(). Only this class defines the order in which
/// nodes are visited and primitives are tested.
///
/// Each visit tests the boxes of the node's children. Among the children that the ray meets, leaves come
/// first, nearest first. Their primitives are tested one by one, none beyond the best hit. Then the stack
/// decides where the ray goes. A blocked light ends the ray.
///
/// `Policy` tests boxes and primitives, and holds the best hit. It has
/// - `Order`, as in GroupStack;
/// - `const WideNode& boxes(line, Time* t_near, uint32_t& hits)`: sets bit i of `hits` if child i is met, and
///   t_near[i];
/// - `void test(half_line)`, for a primitive;
/// - `bool is_list()` and `uint32_t next_page(line)`, 0 after the last, if the structure may be a list of all
///   primitives; boxes() then returns a page of it;
/// - `bool enters()`, if there may be instances: true if the last boxes() returned an instance;
/// - `Time t_best()`, the distance to beat, and `bool stop()`: the light is blocked.
///
/// The caller owns way, stack and arrays, so that the rest can stay in registers.
template <class Policy> class TreeWalk {
public:
    using Order = typename Policy::Order;
    using Time = typename Order::Time;

    RAYCLOCK_INLINE TreeWalk(Policy& policy, GroupStack<Order>& stack, WalkRoom<Order>& room)
        : policy_(policy), stack_(stack), room_(room) {}

    RAYCLOCK_INLINE void start(std::uint32_t root) {
        line_ = root;
        stack_.clear();
    }
    /// Returns the line of the next node; between visit() and decide(), the line of this one.
    std::uint32_t line() const { return line_; }
    const WideNode& node() const { return *node_; }   ///< the node visited
    std::uint32_t hits() const { return hits_; }   ///< children of this node that the ray meets, one bit each
    bool enters() const {                          ///< true if an instance was visited
        if constexpr (requires { policy_.enters(); })
            return policy_.enters();
        else
            return false;
    }
    const Time* t_near() const { return room_.t_near.data(); }
    int stack_height() const { return stack_.height(); }

    /// Tests a node's boxes. Returns true if there is a primitive to test.
    RAYCLOCK_INLINE bool visit() {
        node_ = &policy_.boxes(line_, room_.t_near.data(), hits_);
        met_.node = node_;
        met_.keys = room_.leaves.data();
        met_.leaves =
            Order::sort(hits_ & ~std::uint32_t(node_->inner_mask), room_.t_near.data(), room_.leaves.data());
        if (met_.leaves == 0 || policy_.t_best() < met_.near(0)) return false;
        cursor_.leaf = 0;
        cursor_.enter(met_);
        return true;
    }
    /// Returns the half line of the primitive to test.
    std::uint32_t prim() const { return cursor_.half_line; }
    /// Advances after a test. Returns true if there is another primitive.
    RAYCLOCK_INLINE bool advance() { return !policy_.stop() && cursor_.advance(met_, policy_.t_best()); }
    /// Moves to the next node, or to the ray's end. Returns the number of groups dropped on the way.
    RAYCLOCK_INLINE std::uint32_t decide(bool& done) {
        const bool stop = policy_.stop();
        if constexpr (requires { policy_.next_page(line_); })
            if (policy_.is_list()) {
                line_ = policy_.next_page(line_);
                done = stop || line_ == 0;
                return 0;
            }
        const std::uint32_t inner =
            stop ? 0 : Order::sort(hits_ & node_->inner_mask, room_.t_near.data(), stack_.place());
        Decision decision = stack_.decide(policy_.t_best(), stop, node_->base, inner);
        std::uint32_t dropped = 0;
        for (; decision.action == Decision::Action::again; ++dropped)
            decision = stack_.decide(policy_.t_best(), false, 0, 0);
        done = decision.action == Decision::Action::done;
        if (!done) line_ = decision.addr;
        return dropped;
    }

    /// Walks the whole ray. It calls `watch` after each test of boxes, before each test of a primitive, and
    /// after each decision: visit(walk), test(half_line), decided(dropped, done).
    template <class Watch> RAYCLOCK_INLINE void run(std::uint32_t root, Watch&& watch) {
        start(root);
        for (bool done = false; !done;) {
            bool more = visit();
            watch.visit(*this);
            for (; more; more = advance()) {
                const std::uint32_t half_line = prim();
                watch.test(half_line);
                policy_.test(half_line);
            }
            const std::uint32_t dropped = decide(done);
            watch.decided(dropped, done);
        }
    }

private:
    Policy& policy_;
    GroupStack<Order>& stack_;
    WalkRoom<Order>& room_;
    std::uint32_t line_ = 0, hits_ = 0;
    const WideNode* node_ = nullptr;
    MetLeaves<Order> met_;
    LeafCursor cursor_;
};
