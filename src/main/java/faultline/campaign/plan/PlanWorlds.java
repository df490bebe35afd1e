package faultline.campaign.plan;

import faultline.scenario.xml.XmlElement;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;

/** All worlds of a plan, numbered consecutively. Trees of generated worlds are cached. Safe on any thread. */
final class PlanWorlds {

    private static final int MAX_KEPT = 64;

    private final List<WorldSource> sources;
    private final int count;
    private final Map<Integer, XmlElement> kept = new LinkedHashMap<>(MAX_KEPT, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Integer, XmlElement> eldest) {
            return size() > MAX_KEPT;
        }
    };

    PlanWorlds(List<WorldSource> sources) {
        this.sources = List.copyOf(sources);
        this.count = sources.stream().mapToInt(WorldSource::count).sum();
    }

    List<WorldSource> sources() {
        return sources;
    }

    int count() {
        return count;
    }

    String label(int index) {
        return at(index, WorldSource::label);
    }

    synchronized XmlElement root(int index) {
        return kept.computeIfAbsent(index, missing -> at(missing, WorldSource::root));
    }

    /** Calls the source of a world with the number of the world in that source. */
    private <T> T at(int index, BiFunction<WorldSource, Integer, T> property) {
        int rest = index;
        for (WorldSource source : sources) {
            if (rest < source.count()) {
                return property.apply(source, rest);
            }
            rest -= source.count();
        }
        throw new IndexOutOfBoundsException(index);
    }
}
