package faultline.campaign.plan;

import faultline.scenario.xml.XmlElement;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.function.BiFunction;

/** All worlds of a plan, numbered consecutively. Trees of generated worlds are cached. Safe on any thread. */
final class PlanWorlds {

    private static final int MAX_KEPT = 64;

    /** The sources by the number of the first world of each. */
    private final NavigableMap<Integer, WorldSource> sources = new TreeMap<>();

    private final int count;
    private final Map<Integer, XmlElement> kept = new LinkedHashMap<>(MAX_KEPT, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Integer, XmlElement> eldest) {
            return size() > MAX_KEPT;
        }
    };

    PlanWorlds(List<WorldSource> sources) {
        int first = 0;
        for (WorldSource source : sources) {
            this.sources.put(first, source);
            first += source.count();
        }
        this.count = first;
    }

    /** Returns sources of all kinds of worlds, see {@link WorldSource#kinds}. */
    List<WorldSource> kinds() {
        return WorldSource.kinds(sources.values());
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
        Map.Entry<Integer, WorldSource> source = sources.floorEntry(index);
        return property.apply(source.getValue(), index - source.getKey());
    }
}
