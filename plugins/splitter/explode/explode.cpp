/// Parts of a surface pushed apart: by forces around a selection (Bruckner, Groeller, Exploded Views for Volume Data, TVCG 2006), or one by one
/// along axes so that none moves through another (Li, Agrawala, Curless, Salesin, Automated Generation of Interactive 3D Exploded View
/// Diagrams, SIGGRAPH 2008).

#include <algorithm>
#include <list>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>
#include <lumen/mesh.h>

#include "forces.h"
#include "graph.h"

namespace {

struct Explode : lumen::Splitter {
  explicit Explode(lumen::Binding& binding) : Splitter(binding) { follow_hand(); }

  lumen::Property<lumen::Choice> layout{this, "layout", {"forces"}, {.doc = "what moves the parts: forces around the selection, or a graph of what blocks what, by which none moves through another", .choices = {"forces", "graph"}}};
  lumen::Property<float> degree{this, "degree", 0.5f, {.min = 0, .max = 1, .doc = "how far the parts are apart; 0 leaves the surface as it is"}};
  lumen::Property<std::string> group_by{this, "group_by", {}, {.doc = "the array whose values make the parts; empty: those of the array component, or connected ones"}};
  lumen::Property<std::vector<int>> selection{this, "selection", {}, {.min = 0, .doc = "numbers of parts that stay in place, and that the others leave"}};
  lumen::Property<std::vector<int>> exposed{this, "exposed", {}, {.min = 0, .doc = "numbers of parts that alone come out, with what is in their way; empty: all do"}};
  lumen::Property<float> spacing{this, "spacing", 0.08f, {.min = 0, .max = 10, .unit = "radii", .doc = "between parts that were in contact, of the surface's radius", .group = "Graph", .when = "layout = graph"}};
  lumen::Property<lumen::Choice> axes{this, "axes", {"world"}, {.doc = "along which the parts come out", .group = "Graph", .when = "layout = graph", .choices = {"world", "principal"}}};
  lumen::Property<float> return_force{this, "return_force", 1.0f, {.min = 0.05, .max = 100, .doc = "strength that draws parts back to their places", .group = "Forces", .when = "layout = forces", .logarithmic = true}};
  lumen::Property<float> explosion_force{this, "explosion_force", 0.7f, {.min = 0, .max = 100, .doc = "strength that drives parts away from the selection, or from the center of all", .group = "Forces", .when = "layout = forces"}};
  lumen::Property<float> viewing_force{this, "viewing_force", 0.3f, {.min = 0, .max = 100, .doc = "strength that drives parts out of the sight of the selection; needs one", .group = "Forces", .when = "layout = forces"}};
  lumen::Property<float> spacing_force{this, "spacing_force", 0.05f, {.min = 0, .max = 100, .doc = "strength that drives parts away from each other", .group = "Forces", .when = "layout = forces"}};
  lumen::Property<std::vector<float>> pulled{this, "pulled", {}, {.min = 0, .max = 1, .doc = "degree of each part by itself, by number; it holds where it is more than the degree of all", .advanced = true}};
  lumen::Property<lumen::Reference> hand{this, "hand", {}, {.doc = "the interactor.explode under whose pointer parts come out; it enters itself", .accepts = "interactor", .advanced = true}};
  lumen::Property<std::vector<float>> riffled{this, "riffled", {}, {.min = 0, .max = 1, .doc = "as pulled, for as long as the pointer is there; follows the hand", .advanced = true}};
  lumen::Property<std::vector<float>> ways{this, "ways", {}, {.unit = "world", .doc = "x, y, z of each part's move at degree 1, by number, in the surface that came last; found by the layout", .advanced = true, .affects = lumen::Affects::nothing}};

  void changed(std::string_view property) override {
    if (property != "hand") return;
    if (hand->empty()) riffled.unlink();
    follow_hand();
  }

  lumen::Split split(const lumen::SplitSurface& surface) override {
    if (surface.mesh == nullptr) return {};
    Laid& laid = laid_of(surface);
    const Pieces& pieces = laid.pieces;
    if (pieces.list.empty()) return {};
    if (pieces.left_together >= 0)
      report(lumen::Severity::note, "'" + surface.mesh->origin + "' has " + lumen::grouped(std::size_t(pieces.numbers)) + " parts: the smallest stay, together, beside the largest " +
                                        std::to_string(Pieces::most - 1));
    find_layout(laid);
    tell_ways(laid, surface.camera);
    const std::vector<glm::vec3> moves = moves_of(laid, wanted(pieces), surface.camera);
    lumen::Split split{.parts = {}, .groups = pieces.groups};
    for (std::size_t i = 0; i < pieces.list.size(); ++i) {
      lumen::Part part{.transform = moves[i] == glm::vec3(0) ? glm::mat4(1) : glm::translate(glm::mat4(1), moves[i]), .group = pieces.list[i].number};
      // Nothing else is cut here: of another splitter's cuts none is left open by this one.
      if (!pieces.list[i].torn) part.openings.emplace();
      split.parts.push_back(std::move(part));
    }
    return split;
  }

 private:
  void follow_hand() {
    if (!hand->empty()) riffled.link(hand->id + ".riffled");
  }

  /// A surface, and what is slow to find of it.
  struct Laid {
    explicit Laid(PiecesAsked asked) : pieces(std::move(asked)) {}
    Pieces pieces;
    std::optional<Blocking> blocking;
    bool principal = false;      ///< the axes of `blocking`
    std::optional<ExplosionGraph> graph;
    std::optional<ForceLayout> forces;
    std::uint64_t found = 0;     ///< which of all layouts so far `graph` or `forces` is
  };

  Laid& laid_of(const lumen::SplitSurface& surface) {
    PiecesAsked asked{.mesh = surface.mesh, .object_to_world = surface.object_to_world, .group_by = group_by};
    std::erase_if(laid_, [](const Laid& laid) { return laid.pieces.asked.mesh.expired(); });
    const auto found = std::find_if(laid_.begin(), laid_.end(), [&](const Laid& laid) { return laid.pieces.asked.same(asked); });
    if (found != laid_.end()) return *found;
    // Grouped otherwise, none is asked for again.
    std::erase_if(laid_, [&](const Laid& laid) { return laid.pieces.asked.group_by != asked.group_by; });
    if (laid_.size() >= most_surfaces) laid_.pop_front();
    return laid_.emplace_back(std::move(asked));
  }

  bool by_graph() const { return layout.get() == "graph"; }

  /// Indices of the parts with these numbers.
  static std::vector<int> indices(const Pieces& pieces, const std::vector<int>& numbers) {
    std::vector<int> indices;
    for (std::size_t i = 0; i < pieces.list.size(); ++i)
      if (std::find(numbers.begin(), numbers.end(), pieces.list[i].number) != numbers.end()) indices.push_back(int(i));
    return indices;
  }

  void find_layout(Laid& laid) {
    std::vector<int> fixed = indices(laid.pieces, selection);
    if (!by_graph()) {
      if (laid.forces && laid.forces->fixed() == fixed) return;
      laid.forces.emplace(laid.pieces, std::move(fixed));
      laid.found = ++found_;
      return;
    }
    if (laid.pieces.left_together >= 0) fixed.push_back(laid.pieces.left_together);
    const bool principal = axes.get() == "principal";
    if (!laid.blocking || laid.principal != principal) {
      laid.blocking.emplace(laid.pieces, principal ? principal_axes(laid.pieces) : glm::mat3(1));
      laid.principal = principal;
      laid.graph.reset();
    }
    ExplosionGraph::Asked asked{.fixed = std::move(fixed), .gap = spacing * laid.pieces.radius};
    if (!laid.graph || laid.graph->asked() != asked) {
      laid.graph.emplace(*laid.blocking, std::move(asked));
      laid.found = ++found_;
    }
    tell_limits(laid);
  }

  void tell_limits(const Laid& laid) const {
    const std::string name = "'" + laid.pieces.asked.mesh.lock()->origin + "': ";
    const auto tell = [&](int count, const char* what) {
      if (count > 0) report(lumen::Severity::note, name + std::to_string(count) + what);
    };
    tell(laid.graph->enclosed(), " parts stay with the ones that hold them: cut these first, say by a splitter.plane before this one");
    tell(laid.graph->stuck(), " parts are not free along any axis and stay");
    tell(laid.blocking->intersecting(), " pairs of parts meet where they are: these may move through each other");
    tell(laid.blocking->given_up(), " pairs of parts have too many triangles: they are taken to block each other");
  }

  /// The degree of each part.
  std::vector<float> wanted(const Pieces& pieces) const {
    const auto own = [](const std::vector<float>& list, int number) { return std::size_t(number) < list.size() ? list[std::size_t(number)] : 0.0f; };
    const std::vector<int>& targets = exposed;
    std::vector<float> degrees;
    for (const Piece& piece : pieces.list) {
      const bool all = targets.empty() || std::find(targets.begin(), targets.end(), piece.number) != targets.end();
      degrees.push_back(std::max({all ? degree.get() : 0.0f, own(pulled, piece.number), own(riffled, piece.number)}));
    }
    if (pieces.left_together >= 0) degrees[std::size_t(pieces.left_together)] = 0;
    return degrees;
  }

  std::vector<glm::vec3> moves_of(const Laid& laid, const std::vector<float>& degrees, const lumen::Camera& camera) const {
    if (by_graph()) return laid.graph->moves(degrees);
    return laid.forces->moves(degrees, strengths(), camera);
  }

  Strengths strengths() const { return {return_force, explosion_force, viewing_force, spacing_force}; }

  /// For hands: as long as there is one.
  void tell_ways(const Laid& laid, const lumen::Camera& camera) {
    if (hand->empty() || &laid != &laid_.back()) return;
    const lumen::Camera seen = !by_graph() && laid.forces->views(strengths()) ? camera : lumen::Camera{};
    const Told now{by_graph(), laid.found, strengths(), seen};
    if (told_ == now) return;
    told_ = now;
    std::vector<float> degrees(laid.pieces.list.size(), 1.0f), told(3 * std::size_t(laid.pieces.numbers), 0.0f);
    if (laid.pieces.left_together >= 0) degrees[std::size_t(laid.pieces.left_together)] = 0;
    const std::vector<glm::vec3> moves = moves_of(laid, degrees, camera);
    for (std::size_t i = 0; i < moves.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) told[3 * std::size_t(laid.pieces.list[i].number) + std::size_t(axis)] = moves[i][axis];
    ways.set_default(std::move(told));
  }

  /// What the ways were told of.
  struct Told {
    bool by_graph = false;
    std::uint64_t found = 0;     ///< which layout; 0: nothing was told
    Strengths strengths;
    lumen::Camera camera;
    bool operator==(const Told&) const = default;
  };

  static constexpr std::size_t most_surfaces = 16;
  std::list<Laid> laid_;
  std::uint64_t found_ = 0;      ///< layouts, so far
  Told told_;
};

}  // namespace

LUMEN_PLUGIN(Explode, "splitter.explode", "Parts of a surface pushed apart, by forces or by what blocks what. Bruckner, Groeller, TVCG 2006; Li, Agrawala, Curless, Salesin, SIGGRAPH 2008.")
