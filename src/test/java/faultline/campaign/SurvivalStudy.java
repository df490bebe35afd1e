package faultline.campaign;

import faultline.control.Controller;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Observation;
import faultline.control.PeriodicController;
import faultline.control.Telemetry;
import faultline.control.WallSide;
import faultline.control.ladder.FaultTolerantFollower;
import faultline.control.wallfollower.WallFollower;
import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.WallCircuit;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.LongStream;

/** A fast loop of world and controller for trying faults that need not be in any scenario. */
final class SurvivalStudy {

    static final List<String> KINDS = List.of(
            "off",
            "stuck",
            "stucklast",
            "stuckwanted",
            "bias",
            "biasneg",
            "scale",
            "drift",
            "dropout",
            "bursts",
            "noise",
            "quantised",
            "delayed",
            "range",
            "cone",
            "widecone",
            "ghost",
            "crosstalk",
            "misalign");
    static final double DT = 0.01;

    static final class Injection {
        final String kind;
        final int sensor;
        final double value;
        final SplittableRandom random;
        final List<Double> history = new ArrayList<>();
        double last = Double.NaN;
        boolean burst;
        long onset = -1;

        Injection(String kind, int sensor, SplittableRandom random) {
            this.kind = kind;
            this.sensor = sensor;
            this.random = random;
            this.value = draw(kind, random);
        }

        static double draw(String kind, SplittableRandom r) {
            return switch (kind) {
                case "stuck" -> r.nextDouble(0, 0.8);
                case "bias" -> r.nextDouble(0.03, 0.3);
                case "biasneg" -> r.nextDouble(-0.3, -0.03);
                case "scale" -> r.nextBoolean() ? r.nextDouble(0.5, 0.9) : r.nextDouble(1.1, 1.8);
                case "drift" -> (r.nextBoolean() ? 1 : -1) * r.nextDouble(0.002, 0.02);
                case "dropout" -> r.nextDouble(0.2, 0.98);
                case "bursts" -> r.nextDouble(0.1, 1);
                case "noise" -> r.nextDouble(0.01, 0.1);
                case "quantised" -> r.nextDouble(0.01, 0.1);
                case "delayed" -> r.nextDouble(0.05, 0.5);
                case "range" -> r.nextDouble(0.05, 0.4);
                case "cone" -> r.nextDouble(0.5, 8);
                case "widecone" -> r.nextDouble(30, 60);
                case "ghost" -> r.nextDouble(0.02, 0.5);
                case "crosstalk" -> r.nextDouble(0.1, 0.9);
                case "misalign" -> (r.nextBoolean() ? 1 : -1) * r.nextDouble(5, 30);
                default -> 0;
            };
        }

        double apply(double[] all, long tick, RobotSpec robot) {
            double reading = all[sensor];
            double range = robot.sensors().get(sensor).range();
            if (onset < 0) {
                onset = tick;
                last = reading;
            }
            history.add(reading);
            double out =
                    switch (kind) {
                        case "off" -> Reading.OFF;
                        case "stuck" -> value;
                        case "stuckwanted" -> 0.25;
                        case "stucklast" -> last;
                        case "bias", "biasneg" -> Math.max(0, reading + value);
                        case "scale" -> reading * value;
                        case "drift" -> Math.max(0, reading + value * (tick - onset) * DT);
                        case "dropout" -> random.nextDouble() < value ? Reading.NOTHING : reading;
                        case "bursts" -> {
                            burst = burst ? random.nextDouble() > DT / 0.5 : random.nextDouble() < value * DT;
                            yield burst ? Reading.NOTHING : reading;
                        }
                        case "noise" -> Math.max(0, reading + value * random.nextGaussian());
                        case "quantised" -> Math.round(reading / value) * value;
                        case "delayed" -> history.get(Math.max(0, history.size() - 1 - (int) Math.round(value / DT)));
                        case "range" -> reading > value ? Reading.NOTHING : reading;
                        case "ghost" -> random.nextDouble() < value ? random.nextDouble(0.05, range) : reading;
                        case "crosstalk" ->
                            random.nextDouble() < value ? Math.min(reading, all[(sensor + 1) % all.length]) : reading;
                        default -> reading;
                    };
            return out > range ? Reading.NOTHING : out;
        }

        RobotSpec optics(RobotSpec robot) {
            SensorSpec s = robot.sensors().get(sensor);
            return switch (kind) {
                case "cone", "widecone" -> robot.withSensor(s.withCone(Math.toRadians(value)));
                case "misalign" -> robot.withSensor(s.withBearing(s.bearing() + Math.toRadians(value)));
                default -> robot;
            };
        }
    }

    record Trial(
            long seed,
            List<String> kinds,
            List<Integer> sensors,
            boolean diagnosis,
            int offMask,
            double noise,
            double mismatch,
            boolean right) {}

    record Outcome(
            Trial trial,
            boolean contact,
            boolean carried,
            boolean stopped,
            double share,
            double delay,
            int wronglyDistrusted,
            String note,
            boolean lowerRung,
            double ticksSeconds) {}

    static Outcome run(Trial t) {
        return run(t, null);
    }

    interface Watcher {
        void tick(World world, Decision decision, FaultTolerantFollower follower);
    }

    static Outcome run(Trial t, Watcher watcher) {
        SplittableRandom random = new SplittableRandom(t.seed * 7919 + 13);
        RandomRoom room = RandomRoom.ofSeed(t.seed);
        RobotSpec believed = RobotSpec.DEFAULT;
        for (int i = 0; i < 8; i++) {
            SensorSpec s = believed.sensors().get(i);
            believed = believed.withSensor(s.withNoise(t.noise).withOn((t.offMask >> i & 1) == 0));
        }
        double kl = 1 + t.mismatch * random.nextDouble(-1, 1);
        double kr = 1 + t.mismatch * random.nextDouble(-1, 1);
        RobotSpec real = believed;
        if (t.mismatch > 0) {
            real = new RobotSpec(
                    believed.length(),
                    believed.width(),
                    believed.track() * (1 + t.mismatch * random.nextDouble(-1, 1)),
                    believed.speed(),
                    believed.turnRate(),
                    MotorSpec.DEFAULT,
                    believed.sensors());
        }
        World world = new World(room.world(), real, room.start(), DT, t.seed);
        WallFollowing spec = new WallFollowing(
                0.25, t.right ? WallSide.RIGHT : WallSide.LEFT, 0, WallFollowing.DEFAULT.timingRule());
        FaultTolerantFollower tolerant = t.diagnosis ? new FaultTolerantFollower(spec) : null;
        Controller controller = new PeriodicController(t.diagnosis ? tolerant : new WallFollower(spec), 0);
        List<Injection> faults = new ArrayList<>();
        double lapGuess = 60;
        double[] at = new double[t.kinds.size()];
        for (int i = 0; i < at.length; i++) {
            faults.add(new Injection(t.kinds.get(i), t.sensors.get(i), random.split()));
            at[i] = random.nextDouble(3, 3 + lapGuess);
        }
        double first = at.length == 0 ? 0 : java.util.Arrays.stream(at).min().getAsDouble();
        double lastFault =
                at.length == 0 ? 0 : java.util.Arrays.stream(at).max().getAsDouble();
        CarryOnMetrics judge = new CarryOnMetrics(new WallCircuit(room.world(), 0.35), 0.3, lastFault);
        Decision next = new Decision(0, 0, Telemetry.ofState(FollowerState.SEARCH));
        double delay = Double.NaN;
        int wrong = 0;
        int faulty = 0;
        for (int s : t.sensors) {
            faulty |= 1 << s;
        }
        world.sense();
        long tick = 0;
        boolean stopped = false;
        while (!judge.isDecided()) {
            double[] readings = world.reportedReadings();
            double time = tick * DT;
            for (int i = 0; i < at.length; i++) {
                if (time >= at[i]) {
                    if (faults.get(i).onset < 0 && tick > 0) {
                        RobotSpec seen = faults.get(i).optics(world.robot());
                        if (seen != world.robot()) {
                            world.execute(
                                    new Command.ConfigureSensor(seen.sensors().get(faults.get(i).sensor)));
                        }
                    }
                    readings[faults.get(i).sensor] = faults.get(i).apply(readings, tick, believed);
                }
            }
            Decision decided = controller.decide(new Observation(tick, DT, believed, readings));
            if (tolerant != null) {
                int distrusted = ~tolerant.diagnosis().trusted() & 0xFF;
                wrong |= distrusted & ~faulty & ~t.offMask;
                if (Double.isNaN(delay)
                        && at.length > 0
                        && time >= at[0]
                        && (distrusted >> t.sensors.get(0) & 1) != 0) {
                    delay = time - at[0];
                }
                stopped = tolerant.isStopped();
            }
            double sl = t.right ? kr : kl;
            double sr = t.right ? kl : kr;
            world.move(decided.leftVolts() * sl, decided.rightVolts() * sr);
            world.sense();
            next = decided;
            tick++;
            judge.update(
                    tick * DT,
                    world.pose().position(),
                    next.telemetry().state() == FollowerState.SEARCH,
                    world.collision().isPresent());
            if (watcher != null) {
                watcher.tick(world, decided, tolerant);
            }
        }
        double share = judge.share().orElse(0);
        boolean contact = world.collision().isPresent();
        boolean carried = judge.carriedOn();
        boolean lower = tolerant != null && (tolerant.diagnosis().trusted() & 0xFF & ~t.offMask) != (0xFF & ~t.offMask);
        String note = String.format(
                Locale.ROOT,
                "%s end=%.0f share=%.2f wrong=%s",
                world.collision()
                        .map(c -> "CONTACT " + c.obstacle() + " at " + c.time())
                        .orElse("-"),
                tick * DT,
                share,
                Integer.toBinaryString(wrong));
        StringBuilder values = new StringBuilder(note);
        for (int i = 0; i < at.length; i++) {
            values.append(String.format(Locale.ROOT, " %s@%.2f=%.3f", faults.get(i).kind, at[i], faults.get(i).value));
        }
        return new Outcome(t, contact, carried, stopped, share, delay, wrong, values.toString(), lower, tick * DT);
    }

    static final String[] NAMES = {
        "front", "front-left", "left", "rear-left", "rear", "rear-right", "right", "front-right"
    };

    /** Arguments: mode, first seed, runs per cell, kinds, sensors, then options. */
    public static void main(String[] args) {
        String mode = args[0];
        long seed = Long.parseLong(args[1]);
        int n = Integer.parseInt(args[2]);
        boolean verbose = List.of(args).contains("-v");
        boolean off = List.of(args).contains("-off");
        boolean right = List.of(args).contains("-right");
        double mismatch = List.of(args).contains("-mm") ? 0.05 : 0;
        double noise = List.of(args).contains("-noise") ? 0.008 : 0;
        if (mode.equals("faults")) {
            List<String> kinds = args[3].equals("all") ? KINDS : List.of(args[3].split(","));
            int[] sensors = args[4].equals("all")
                    ? IntStream.range(0, 8).toArray()
                    : java.util.Arrays.stream(args[4].split(","))
                            .mapToInt(List.of(NAMES)::indexOf)
                            .toArray();
            int all = 0;
            int good = 0;
            int contacts = 0;
            int stops = 0;
            for (int s : sensors) {
                for (String kind : kinds) {
                    List<Outcome> cell = LongStream.range(seed, seed + n)
                            .mapToObj(i -> run(new Trial(
                                    i + 1000L * s, List.of(kind), List.of(s), !off, 0, noise, mismatch, right)))
                            .toList();
                    int ok = (int) cell.stream().filter(Outcome::carried).count();
                    int hit = (int) cell.stream().filter(Outcome::contact).count();
                    int stop = (int)
                            cell.stream().filter(o -> !o.carried && o.stopped).count();
                    double[] delays = cell.stream()
                            .mapToDouble(Outcome::delay)
                            .map(d -> Double.isNaN(d) ? 999 : d)
                            .sorted()
                            .toArray();
                    System.out.printf(
                            Locale.ROOT,
                            "%-11s %-12s carried %3d/%d contact %d stopped %d wrong %d delay median %.2f p90 %.2f%n",
                            NAMES[s],
                            kind,
                            ok,
                            n,
                            hit,
                            stop,
                            cell.stream().filter(o -> o.wronglyDistrusted != 0).count(),
                            delays[delays.length / 2],
                            delays[delays.length * 9 / 10]);
                    if (verbose) {
                        cell.stream()
                                .filter(o -> !o.carried)
                                .forEach(o -> System.out.println("     seed " + o.trial.seed + " " + o.note));
                    }
                    all += n;
                    good += ok;
                    contacts += hit;
                    stops += stop;
                }
            }
            System.out.printf(
                    Locale.ROOT,
                    "ALL carried %d/%d = %.3f contacts %d stopped %d%n",
                    good,
                    all,
                    (double) good / all,
                    contacts,
                    stops);
        } else if (mode.equals("healthy") || mode.equals("masks") || mode.equals("one") || mode.equals("two")) {
            many(mode, seed, n, off, noise, mismatch, right, verbose);
        }
    }

    static void many(
            String mode, long seed, int n, boolean off, double noise, double mismatch, boolean right, boolean verbose) {
        int[] ok = new int[10];
        int[] count = new int[10];
        int[] hits = new int[10];
        int[] stops = new int[10];
        int wrong = 0;
        int lower = 0;
        double seconds = 0;
        for (long i = seed; i < seed + n; i++) {
            SplittableRandom r = new SplittableRandom(i * 31 + 5);
            int group = 0;
            Trial t;
            if (mode.equals("healthy")) {
                t = new Trial(i, List.of(), List.of(), !off, 0, noise, mismatch, right);
            } else if (mode.equals("masks")) {
                int mask = r.nextInt(256);
                group = (mask & 14) == 14 ? 1 : 0;
                t = new Trial(i, List.of(), List.of(), !off, mask, noise, mismatch, right);
            } else if (mode.equals("one")) {
                group = (int) (i % 8);
                t = new Trial(i, List.of(), List.of(), !off, 0xFF & ~(1 << group), noise, mismatch, right);
            } else {
                int a = r.nextInt(8);
                int b = (a + 1 + r.nextInt(7)) % 8;
                t = new Trial(
                        i,
                        List.of(KINDS.get(r.nextInt(KINDS.size())), KINDS.get(r.nextInt(KINDS.size()))),
                        List.of(a, b),
                        !off,
                        0,
                        noise,
                        mismatch,
                        right);
            }
            Outcome o = run(t);
            count[group]++;
            ok[group] += o.carried ? 1 : 0;
            hits[group] += o.contact ? 1 : 0;
            stops[group] += o.stopped ? 1 : 0;
            wrong += o.wronglyDistrusted != 0 ? 1 : 0;
            lower += o.lowerRung ? 1 : 0;
            seconds += o.ticksSeconds;
            if (verbose && !o.carried) {
                System.out.println("  seed " + i + " mask " + Integer.toBinaryString(t.offMask) + " sensors "
                        + t.sensors + " " + o.note + (o.stopped ? " STOPPED" : ""));
            }
        }
        for (int g = 0; g < 10; g++) {
            if (count[g] > 0) {
                System.out.printf(
                        Locale.ROOT,
                        "%s group %s carried %d/%d contact %d stopped %d%n",
                        mode,
                        mode.equals("one") ? NAMES[g] : "" + g,
                        ok[g],
                        count[g],
                        hits[g],
                        stops[g]);
            }
        }
        System.out.printf(Locale.ROOT, "wrong %d lower at end %d hours %.2f%n", wrong, lower, seconds / 3600);
    }
}
