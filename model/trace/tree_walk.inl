// A ray's walk through the tree of boxes. Included inside a namespace, once for each instruction set; for
// whoever needs no more than the baseline, walk.hpp has it.

/// What happens to one ray, step by step, or in one go by run(). This is the only place that says in which
/// order nodes are visited and primitives are tested.
///
/// In each visit the boxes of the node's children are tested. Of the children that the ray meets, leaves come
/// first, nearest first, and their primitives are tested one by one, none beyond the best hit; then the stack
/// decides where the ray goes. A blocked light ends the ray.
///
/// `Way` knows what boxes and primitives are, and the best hit. It has
///   - `Order`, as GroupStack has it;
///   - `const WideNode& boxes(line, Time* t_near, uint32_t& hits)`: bit i of `hits` says that child i is met,
///     and t_near[i] where;
///   - `void test(half_line)`, of a primitive;
///   - if there may be no nodes, but a list of all primitives, `bool is_list()`, and `uint32_t
///     next_page(line)`, 0 after the last: boxes() then gives a page of it;
///   - if there may be instances, `bool enters()`: what boxes() gave is one, and no node;
///   - `Time t()`, the distance to beat, and `bool stop()`: the light is blocked.
/// Way, stack and arrays are the caller's, so that the rest can stay in registers.
template <class Way> class TreeWalk {
public:
    using Order = typename Way::Order;
    using Time = typename Order::Time;

    RAYCLOCK_INLINE TreeWalk(Way& way, GroupStack<Order>& stack, WalkRoom<Order>& room)
        : way_(way), stack_(stack), room_(room) {}

    RAYCLOCK_INLINE void start(std::uint32_t root) {
        line_ = root;
        stack_.clear();
    }
    std::uint32_t line() const { return line_; }   ///< of the next node; between visit() and decide() of this
    const WideNode& node() const { return *node_; }   ///< that is visited
    std::uint32_t hits() const { return hits_; }      ///< its children that the ray meets, bit by bit
    bool enters() const {                             ///< it is no node but an instance
        if constexpr (requires { way_.enters(); })
            return way_.enters();
        else
            return false;
    }
    const Time* t_near() const { return room_.t_near.data(); }
    int stack_height() const { return stack_.height(); }

    /// Tests a node's boxes. True if there is a primitive to be tested.
    RAYCLOCK_INLINE bool visit() {
        node_ = &way_.boxes(line_, room_.t_near.data(), hits_);
        met_.node = node_;
        met_.keys = room_.leaves.data();
        met_.leaves =
            Order::sort(hits_ & ~std::uint32_t(node_->inner_mask), room_.t_near.data(), room_.leaves.data());
        if (met_.leaves == 0 || way_.t() < met_.near(0)) return false;
        cursor_.leaf = 0;
        cursor_.enter(met_);
        return true;
    }
    /// The half line of the primitive to be tested.
    std::uint32_t prim() const { return cursor_.half_line; }
    /// After its test. True if there is another.
    RAYCLOCK_INLINE bool advance() { return !way_.stop() && cursor_.advance(met_, way_.t()); }
    /// To the next node, or the ray's end. Returns how many groups were dropped on the way.
    RAYCLOCK_INLINE std::uint32_t decide(bool& done) {
        const bool stop = way_.stop();
        if constexpr (requires { way_.next_page(line_); })
            if (way_.is_list()) {
                line_ = way_.next_page(line_);
                done = stop || line_ == 0;
                return 0;
            }
        const std::uint32_t inner =
            stop ? 0 : Order::sort(hits_ & node_->inner_mask, room_.t_near.data(), stack_.place());
        Turn turn = stack_.decide(way_.t(), stop, node_->base, inner);
        std::uint32_t dropped = 0;
        for (; turn.kind == Turn::Kind::again; ++dropped) turn = stack_.decide(way_.t(), false, 0, 0);
        done = turn.kind == Turn::Kind::done;
        if (!done) line_ = turn.addr;
        return dropped;
    }

    /// All of it. `watch` is told of each visit when its boxes are tested, of each primitive, and of each
    /// decision: visit(walk), test(half_line), decided(dropped, done).
    template <class Watch> RAYCLOCK_INLINE void run(std::uint32_t root, Watch&& watch) {
        start(root);
        for (bool done = false; !done;) {
            bool more = visit();
            watch.visit(*this);
            for (; more; more = advance()) {
                const std::uint32_t half_line = prim();
                watch.test(half_line);
                way_.test(half_line);
            }
            const std::uint32_t dropped = decide(done);
            watch.decided(dropped, done);
        }
    }

private:
    Way& way_;
    GroupStack<Order>& stack_;
    WalkRoom<Order>& room_;
    std::uint32_t line_ = 0, hits_ = 0;
    const WideNode* node_ = nullptr;
    MetLeaves<Order> met_;
    LeafCursor cursor_;
};
