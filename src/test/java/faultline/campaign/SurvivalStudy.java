package faultline.campaign;

import faultline.campaign.SurvivalTrial.Conditions;
import faultline.campaign.SurvivalTrial.Outcome;
import faultline.control.WallSide;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.LongFunction;
import java.util.stream.LongStream;

/**
 * Prints tables of survival in random rooms, for trying changes of the diagnosis; campaigns make the published ones.
 */
final class SurvivalStudy {

    private static final double NEVER = 999;

    private final long first;
    private final int runs;
    private final boolean verbose;
    private final Conditions conditions;

    private SurvivalStudy(List<String> arguments) {
        first = Long.parseLong(arguments.get(1));
        runs = Integer.parseInt(arguments.get(2));
        verbose = arguments.contains("-v");
        conditions = new Conditions(
                !arguments.contains("-off"),
                arguments.contains("-right") ? WallSide.RIGHT : WallSide.LEFT,
                arguments.contains("-noise") ? 0.008 : 0,
                arguments.contains("-mismatch") ? 0.05 : 0);
    }

    /**
     * Arguments: {@code faults}, {@code healthy}, {@code masks}, {@code one} or {@code two}, the first room, the runs
     * of each cell, for {@code faults} the kinds and the sensors or {@code all}, and options.
     */
    public static void main(String[] arguments) {
        List<String> all = List.of(arguments);
        SurvivalStudy study = new SurvivalStudy(all);
        switch (all.get(0)) {
            case "faults" -> study.faults(DrawnFault.of(all.get(3)), sensors(all.get(4)));
            case "healthy" -> study.cell("healthy", room -> trial(study, room, 0));
            case "masks" -> study.masks();
            case "one" -> study.oneAlone(sensors(all.size() > 3 ? all.get(3) : "all"));
            case "two" -> study.cell("two", study::twoFaults);
            default -> throw new IllegalArgumentException(all.get(0));
        }
    }

    private static List<Integer> sensors(String names) {
        return names.equals("all") || names.startsWith("-")
                ? List.of(0, 1, 2, 3, 4, 5, 6, 7)
                : Arrays.stream(names.split(","))
                        .map(SurvivalTrial.SENSORS::indexOf)
                        .toList();
    }

    private static SurvivalTrial trial(SurvivalStudy study, long room, int off) {
        return new SurvivalTrial(room, List.of(), List.of(), off, study.conditions);
    }

    private void faults(List<DrawnFault> kinds, List<Integer> sensors) {
        List<Outcome> all = new ArrayList<>();
        for (int sensor : sensors) {
            for (DrawnFault kind : kinds) {
                all.addAll(cell(
                        SurvivalTrial.SENSORS.get(sensor) + " " + kind,
                        room -> new SurvivalTrial(
                                room + 1000L * sensor, List.of(kind), List.of(sensor), 0, conditions)));
            }
        }
        print("ALL", all);
    }

    private SurvivalTrial twoFaults(long room) {
        SplittableRandom random = new SplittableRandom(room * 31 + 5);
        int one = random.nextInt(8);
        int other = (one + 1 + random.nextInt(7)) % 8;
        DrawnFault[] kinds = DrawnFault.values();
        return new SurvivalTrial(
                room,
                List.of(kinds[random.nextInt(kinds.length)], kinds[random.nextInt(kinds.length)]),
                List.of(one, other),
                0,
                conditions);
    }

    /** Every second run has sensors on the wall's side that are all off. */
    private void masks() {
        int side = conditions.side() == WallSide.LEFT ? 0b1110 : 0b1110_0000;
        cell("one on the wall's side", room -> {
            SplittableRandom random = new SplittableRandom(room * 31 + 5);
            int off = random.nextInt(256);
            while ((off & side) == side) {
                off = random.nextInt(256);
            }
            return trial(this, room, off);
        });
        cell(
                "none on the wall's side",
                room -> trial(this, room, new SplittableRandom(room * 31 + 5).nextInt(256) | side));
    }

    private void oneAlone(List<Integer> sensors) {
        for (int sensor : sensors) {
            cell(SurvivalTrial.SENSORS.get(sensor) + " alone", room -> trial(this, room, 0xFF & ~(1 << sensor)));
        }
    }

    private List<Outcome> cell(String name, LongFunction<SurvivalTrial> trials) {
        List<Outcome> cell = LongStream.range(first, first + runs)
                .mapToObj(trials)
                .map(SurvivalTrial::run)
                .toList();
        print(name, cell);
        if (verbose) {
            cell.stream()
                    .filter(outcome ->
                            !outcome.carriedOn() || outcome.trial().sensors().isEmpty() && outcome.lowerRung())
                    .forEach(outcome -> System.out.println("    " + outcome.note()));
        }
        return cell;
    }

    private static void print(String name, List<Outcome> cell) {
        double[] delays = cell.stream()
                .mapToDouble(Outcome::delay)
                .map(delay -> Double.isNaN(delay) ? NEVER : delay)
                .sorted()
                .toArray();
        System.out.printf(
                Locale.ROOT,
                "%-28s carried on %d/%d contacts %d stopped %d false alarms %d lower %d"
                        + " delay %.2f p90 %.2f hours %.2f%n",
                name,
                cell.stream().filter(Outcome::carriedOn).count(),
                cell.size(),
                cell.stream().filter(Outcome::contact).count(),
                cell.stream()
                        .filter(outcome -> !outcome.carriedOn() && outcome.stopped())
                        .count(),
                cell.stream().filter(outcome -> outcome.falseAlarms() > 0).count(),
                cell.stream().filter(Outcome::lowerRung).count(),
                delays[delays.length / 2],
                delays[delays.length * 9 / 10],
                cell.stream().mapToDouble(Outcome::seconds).sum() / 3600);
    }
}
