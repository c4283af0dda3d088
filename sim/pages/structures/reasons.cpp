// What the counters say, in words: of all scenes together, and of each. They are of configuration `default`
// and of the scenes of the page in docs/; other pages leave them out.
#include "sim/pages/structures/page.hpp"

namespace rayclock::structures {

namespace {

struct Reason {
    const char* scene;   ///< empty: all of them
    const char* words;
};
constexpr Reason reasons[] = {
    {"",
     R"(**Boxes lead on six of seven scenes, planes on rings.** A visit of a treelet decides at most eight
exits with 13 small products (7 planes and its box), one of boxes eight children with 48; but space
that is cut in eight still has to be walked cell by cell, and a ray needs 1.4 times as many visits.
trav makes one visit a cycle in both, so visits are what frames cost, and the tests that planes save
are made by a unit that is not the bound. The engine of kd makes the pipeline 15 % smaller and takes
25 of its 161 multipliers away; that is less than it costs in frames, so that per LUT and per
multiplier the two are within 4 % of each other. The goal of 1.4 times as many frames per LUT is not
reached, since most of a pipeline is the same with all of them.

**Globes, which are bounding spheres, lose to boxes everywhere**: the same tree, 1.5 times the visits and
1.3 to 4 times the tests. A sphere around what is long or flat is mostly empty, and those of
neighbours overlap. They are ahead of planes where things are round or small and even (balls, mount,
tetra), and far behind where they are long (gears, rings, tree); there tri is the bound.

**The octree loses to kd everywhere**, with the same gates, and to boxes everywhere but on rings:
its planes lie where the cell's middle is, not where the scene has a gap or a face. Cells that no
plane can empty are halved until the bound on references or the depth ends it, and what is left in
their leaves is tested.

**Caches** of 2 KB or of 128 KB each do not change the order of the four in any scene. Planes and
octants lose more than boxes when caches shrink, since a primitive in several leaves is in several
lines.)"},
    {"gears:8",
     R"(Why: the teeth are long, thin triangles that stand side by side. Boxes around them overlap, which
costs boxes 3.6 tests a ray; planes cut them apart and leave 2.3. But trav is the bound of both (87
and 91 %), and kd visits 1.24 times as many nodes: fewer tests buy nothing. Its 5.4 copies of each
primitive make the image 4.6 times as large and take the primitive cache from 89 to 72 % of hits.
The octree's leaves hold what its bound of references left there: 14 tests a ray, tri is the bound,
and 192 bytes a ray. A sphere around a long triangle is as large as its neighbours' together: 12
tests a ray, and tri is the bound of globes as well.)"},
    {"balls:3",
     R"(Why: small spheres sit on large ones, and between them is nothing. A box around each leaves the
empty space out in one step, and 3.7 visits are enough. Planes go on through empty space: kd cuts
the gaps off one by one, 6.6 visits, and the octree has to halve 12 times before a cell is as small
as the smallest spheres' triangles: 20 visits a ray at a depth of 13. Globes fit spheres: 4.7 visits,
fewer than kd, and in the finished picture, whose spheres are not made of triangles, as many frames
as boxes (2.2 visits against 2.4).)"},
    {"mount:8",
     R"(Why: one sheet of small triangles of equal size, without overlap (1.4 references a primitive for
kd). Boxes fit as well as planes can, and have 1.64 tests a ray against 2.40: a ray that passes
closely over the sheet goes through many cells of kd, each with a reference. In the finished picture
kd makes 5.0 tests a ray against 1.5, and most are of the four glass spheres (camera rays at 64 x
48: 4.3 tests of spheres a ray, boxes 0.4): where a triangle is clipped to its cell, a sphere's part
is only bounded by the sphere's box, so that the heuristic sees no gain in cutting near it. A
quarter of these tests are of a sphere that the ray has tested before. Globes overlap at the edges of
small even triangles, but no more: 5.5 visits, fewer than kd.)"},
    {"rings:3",
     R"(Why: rings are linked, so their boxes overlap whatever the tree: 22 tests a ray, and tri is busy in
97 % of the cycles. Planes cut through the links: 6.2 tests, and 2.5 times as many frames; even the
octree is faster than boxes. It is the only scene of the seven in which tri bounds boxes by far, and
the fair rival there would be boxes with spatial splits (`splits=on`, [decisions](decisions.md)): 8.1 cycles. In the finished
picture all of it is gone: its cylinders have fewer and longer sides (10,502 primitives), kd spends
6.7 of the 8 references that it may on each of them, and what is left in its leaves then is tested:
29 tests a ray, as with boxes, and fewer hits in both caches. The sphere around a ring is full of what
the ring is linked with: 56 tests a ray with globes, the worst of all.)"},
    {"tetra:8",
     R"(Why: the fractal is made by halving, so an octree's planes lie where the scene has its gaps: it
visits fewer nodes than kd (3.84 against 4.46), the only scene where it does. But corners of
tetrahedra meet in those planes, and what touches is cut down to the greatest depth: 123,568 nodes,
18 MB, 84 % of hits, and memory is its bound. Boxes of eight children have 2.7 visits: a
tetrahedron's four quarters, two levels at a time. Globes around them are nearly as good, 3.4 visits.)"},
    {"teapot:12",
     R"(Why: a small scene, all of whose upper nodes lie in the caches (97.5 to 98.6 % of hits), so every
structure reaches 95 to 98 % of its bound, trav, and frames follow visits: boxes 3.15, kd 4.86, the
octree and globes 5.7. Tests differ by less than two a ray, and tri is half idle in all of them.)"},
    {"tree:8",
     R"(Why: the scene is a large empty ground with a dense crown of thin twigs. The mean ray meets the
ground at once, and boxes are done in 2.6 visits; the few rays through the crown make their 2.75
tests a ray, because twigs that lie askew fill little of their boxes, and tri bounds the frame.
Planes cut twigs into pieces (4.3 references each) and save a quarter of the tests, for 1.8 times
the visits. In cells in the middle of the crown the octree cannot separate twigs that grow from one
point: 9.9 tests, and 29 a ray in the finished picture. The sphere around a twig is as wide as the twig
is long: 11.4 tests a ray with globes.)"},
};

}   // namespace

const char* reason(const std::string& scene) {
    for (const Reason& r : reasons)
        if (scene == r.scene) return r.words;
    return "";
}

}   // namespace rayclock::structures
