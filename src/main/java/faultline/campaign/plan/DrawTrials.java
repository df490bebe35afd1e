package faultline.campaign.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;

/** The draws with which some changes of a scenario are tried: those at the ends of intervals, and all words. */
final class DrawTrials {

    /** The number of combinations of draws beyond which only those are tried in which all draws but one are alike. */
    private static final int MAX_COMBINATIONS = 1000;

    /**
     * The distance of mixed draws from the ends. Two intervals may share an end, because no run in practice draws it
     * from both.
     */
    private static final double MARGIN = 1e-3;

    private final double low;
    private final double high;
    /** The draws of each stream. */
    private final Map<String, Set<Double>> streams = new LinkedHashMap<>();

    private DrawTrials(List<ScenarioChange> edits, double low, double high) {
        this.low = low;
        this.high = high;
        edits.stream()
                .flatMap(edit -> edit.values().stream())
                .flatMap(value -> value.draws().stream())
                .forEach(value -> streams.computeIfAbsent(value.stream(), first -> new TreeSet<>())
                        .addAll(draws(value.range())));
    }

    private List<Double> draws(DrawRange range) {
        if (range instanceof DrawRange.Words choice) {
            double count = choice.words().size();
            return IntStream.range(0, choice.words().size())
                    .mapToObj(i -> (i + 0.5) / count)
                    .toList();
        }
        return List.of(low, high);
    }

    /** Returns trials with the same draw for everything; one trial if nothing is drawn. */
    static List<AttributeValue.UniformSource> alike(List<ScenarioChange> edits) {
        DrawTrials trials = new DrawTrials(edits, 0, Math.nextDown(1.0));
        Set<Double> draws = new TreeSet<>(Set.of(trials.low));
        trials.streams.values().forEach(draws::addAll);
        return draws.stream()
                .<AttributeValue.UniformSource>map(draw -> (stream, block) -> draw)
                .toList();
    }

    /**
     * Returns trials with each combination of draws, or with each draw if there are too many; none of a single draw.
     */
    static List<AttributeValue.UniformSource> mixed(List<ScenarioChange> edits) {
        DrawTrials trials = new DrawTrials(edits, MARGIN, 1 - MARGIN);
        if (trials.streams.size() < 2) {
            return List.of();
        }
        double combinations =
                trials.streams.values().stream().mapToDouble(Set::size).reduce(1, (a, b) -> a * b);
        return combinations > MAX_COMBINATIONS ? trials.oneByOne() : trials.combinations();
    }

    private List<AttributeValue.UniformSource> oneByOne() {
        List<AttributeValue.UniformSource> trials = new ArrayList<>();
        streams.forEach((chosen, draws) -> draws.forEach(draw -> {
            for (double other : List.of(low, high)) {
                trials.add((stream, block) -> stream.equals(chosen) ? draw : other);
            }
        }));
        return trials;
    }

    private List<AttributeValue.UniformSource> combinations() {
        List<Map<String, Double>> trials = List.of(Map.of());
        for (Map.Entry<String, Set<Double>> stream : streams.entrySet()) {
            List<Map<String, Double>> longer = new ArrayList<>();
            for (Map<String, Double> trial : trials) {
                for (double draw : stream.getValue()) {
                    Map<String, Double> next = new LinkedHashMap<>(trial);
                    next.put(stream.getKey(), draw);
                    longer.add(next);
                }
            }
            trials = longer;
        }
        return trials.stream()
                .<AttributeValue.UniformSource>map(trial -> (stream, block) -> trial.get(stream))
                .toList();
    }
}
