package faultline.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import faultline.robot.RobotSpec;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The formula of each fault, as docs/faults.md gives it. */
class FaultModelsTest {

    private static final double RANGE = 0.8;
    private static final double DT = 0.01;
    private static final long STREAM = SensorRandom.streamKey(7, "left");

    private final FaultContext context = new FaultContext(100, DT, 0.33);

    private double apply(Fault fault, long tick, double reading) {
        return fault.apply(reading, context.at(tick, RANGE, 0.2, SensorRandom.forTick(STREAM, tick)));
    }

    private double share(Fault fault, double reading) {
        long changed = 0;
        for (long tick = 100; tick < 10_100; tick++) {
            changed += apply(fault, tick, reading) != reading ? 1 : 0;
        }
        return changed / 10_000.0;
    }

    @Test
    void aSensorStuckAtLastRepeatsWhatItReportedBefore() {
        assertEquals(0.33, apply(new SignalFault.StuckAtLast(), 150, 0.6));
    }

    @Test
    void aSensorStuckAtLastReportsNothingThatASmallerRangeExcludes() {
        Fault stuck = new SignalFault.StuckAtLast();
        double held = stuck.apply(0.1, context.at(150, 0.3, 0.2, SensorRandom.forTick(STREAM, 150)));
        assertEquals(Reading.NOTHING, held);
        FaultContext silent = new FaultContext(100, DT, Reading.OFF);
        double none = stuck.apply(0.1, silent.at(150, 0.3, 0.2, SensorRandom.forTick(STREAM, 150)));
        assertTrue(Reading.isOff(none), "stuck while it did not answer");
    }

    @Test
    void aScaledReadingIsMultipliedAndLostBeyondTheRange() {
        assertEquals(0.6, apply(new SignalFault.Scale(1.5), 100, 0.4), 1e-12);
        assertEquals(Reading.NOTHING, apply(new SignalFault.Scale(1.5), 100, 0.6));
    }

    @Test
    void aDriftGrowsFromItsOnset() {
        assertEquals(0.4, apply(new SignalFault.Drift(0.01), 100, 0.4), 1e-12);
        assertEquals(0.41, apply(new SignalFault.Drift(0.01), 200, 0.4), 1e-12);
    }

    @Test
    void aQuantisedReadingIsTheNearestStep() {
        assertEquals(0.4, apply(new SignalFault.Quantised(0.1), 100, 0.44), 1e-12);
        assertEquals(0.5, apply(new SignalFault.Quantised(0.1), 100, 0.45), 1e-12);
    }

    @Test
    void aDelayedReadingIsThatOfSomeTicksAgo() {
        Fault delayed = new SignalFault.Delayed(0.03);
        List<Double> reported = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            reported.add(apply(delayed, 100 + i, 0.1 * i));
        }
        assertEquals(List.of(0.0, 0.0, 0.0, 0.0, 0.1, 0.2), reported);
    }

    @Test
    void aDelayedReadingFromATimeWithoutAnAnswerIsNothing() {
        Fault delayed = new SignalFault.Delayed(0.03);
        List<Double> reported = new ArrayList<>();
        for (int i : new int[] {0, 1, 6, 7, 8, 9, 10}) {
            reported.add(apply(delayed, 100 + i, 0.1 + 0.01 * i));
        }
        double none = Reading.NOTHING;
        assertEquals(List.of(0.1, 0.1, none, none, none, 0.1 + 0.01 * 6, 0.1 + 0.01 * 7), reported);
    }

    @Test
    void aDelayedReadingIsNothingIfASmallerRangeExcludesIt() {
        Fault delayed = new SignalFault.Delayed(0.01);
        apply(delayed, 100, 0.5);
        double late = delayed.apply(0.2, context.at(101, 0.3, 0.2, SensorRandom.forTick(STREAM, 101)));
        assertEquals(Reading.NOTHING, late);
    }

    @Test
    void aDelayTakesNoMoreMemoryTheLongerItLasts() {
        Fault delayed = new SignalFault.Delayed(0.5);
        for (long i = 0; i < 3_000_000; i++) {
            double reading = 1e-7 * i;
            assertEquals(1e-7 * Math.max(0, i - 50), apply(delayed, 100 + i, reading));
        }
        // A tick that no int can hold.
        apply(delayed, 1L << 40, 0.25);
        assertEquals(0.25, apply(delayed, (1L << 40) + 50, 0.7));
    }

    @Test
    void aLongDelayInShortTicksTakesMemoryOnlyWithTime() {
        Fault delayed = new SignalFault.Delayed(10);
        FaultContext shortTicks = new FaultContext(0, 1e-5, 0.33);
        SensorRandom random = SensorRandom.forTick(STREAM, 0);
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = thread.getCurrentThreadAllocatedBytes();
        for (int tick = 0; tick < 100; tick++) {
            assertEquals(0.1, delayed.apply(0.1 + tick, shortTicks.at(tick, RANGE, 0.2, random)));
        }
        long bytes = thread.getCurrentThreadAllocatedBytes() - before;
        assertTrue(bytes < 100_000, bytes + " bytes, of 8 000 000 in the end");
    }

    @Test
    void aDropoutLosesItsShareOfReadingsAndKeepsTheOthersAsTheyAre() {
        assertEquals(0, share(new Fault.Dropout(0), 0.4));
        assertEquals(1, share(new Fault.Dropout(1), 0.4));
        assertEquals(0.3, share(new Fault.Dropout(0.3), 0.4), 0.015);
        int pairs = 0;
        for (long tick = 100; tick < 10_100; tick++) {
            double reading = apply(new Fault.Dropout(0.3), tick, 0.4);
            assertTrue(reading == 0.4 || reading == Reading.NOTHING, "reading " + reading);
            boolean lost = reading == Reading.NOTHING;
            pairs += lost && apply(new Fault.Dropout(0.3), tick + 1, 0.4) == Reading.NOTHING ? 1 : 0;
        }
        assertEquals(0.09, pairs / 10_000.0, 0.01, "losses are independent");
    }

    @Test
    void noiseHasItsStandardDeviation() {
        double squares = 0;
        for (long tick = 100; tick < 10_100; tick++) {
            double error = apply(new SignalFault.Noise(0.02), tick, 0.4) - 0.4;
            squares += error * error;
        }
        assertEquals(0.02, Math.sqrt(squares / 10_000), 0.0005);
    }

    @Test
    void burstsTakeTheShareOfTheirRateAndLength() {
        // A two-state chain: share = rate * length / (1 + rate * length).
        assertEquals(0.5 / 1.5, share(new SignalFault.Bursts(1, 0.5), 0.4), 0.07);
    }

    /** The reference is the probability of the chain after as many steps of one tick. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 10, 100, 100_000})
    void burstsBeginAndEndWhileTheSensorIsOff(int steps) {
        Fault bursts = new SignalFault.Bursts(2, 0.15);
        double begins = 2 * DT;
        double ends = DT / 0.15;
        double expected = 1;
        for (int i = 0; i < steps; i++) {
            expected = expected * (1 - ends) + (1 - expected) * begins;
        }
        int runs = 0;
        int still = 0;
        for (long stream = 0; runs < 4000; stream++) {
            FaultContext chain = new FaultContext(100, DT, 0.3);
            long tick = 100;
            while (tick < 120 && !isInBurst(bursts, chain, stream, tick)) {
                tick++;
            }
            if (tick < 120) {
                runs++;
                still += isInBurst(bursts, chain, stream, tick + steps) ? 1 : 0;
            }
        }
        assertEquals(expected, (double) still / runs, 4 * Math.sqrt(0.25 / runs));
    }

    private static boolean isInBurst(Fault bursts, FaultContext chain, long stream, long tick) {
        SensorRandom random = SensorRandom.forTick(SensorRandom.streamKey(stream, "front"), tick);
        return bursts.apply(0.4, chain.at(tick, RANGE, 0.2, random)) == Reading.NOTHING;
    }

    @Test
    void ghostsAndCrossTalkComeInTheirShareOfTicks() {
        assertEquals(0.3 * 0.5, share(new SignalFault.Ghost(0.3), 0.4), 0.02);
        assertEquals(0.3, share(new SignalFault.CrossTalk(0.3), 0.4), 0.02);
    }

    @Test
    void dirtTakesWhatIsFarther() {
        assertEquals(0.1, apply(new OpticalFault.ShortRange(0.2), 100, 0.1));
        assertEquals(Reading.NOTHING, apply(new OpticalFault.ShortRange(0.2), 100, 0.3));
    }

    @Test
    void opticalFaultsChangeWhatIsSeen() {
        SensorSpec spec = RobotSpec.DEFAULT.sensors().get(2);
        assertEquals(Math.toRadians(4), new OpticalFault.Cone(4).optics(spec).cone(), 1e-12);
        assertEquals(
                Math.toRadians(105),
                new OpticalFault.Misaligned(15).optics(spec).bearing(),
                1e-12);
        assertEquals(Math.toRadians(30), new OpticalFault.SpecularLoss(30).specularAngle(), 1e-12);
    }

    @ParameterizedTest
    @EnumSource
    void aFaultAskedTwiceInATickAnswersTheSame(FaultKind kind) {
        Fault fault = kind.createFault(kind.defaultValue());
        for (long tick = 100; tick < 200; tick++) {
            double first = apply(fault, tick, 0.3);
            assertEquals(first, apply(fault, tick, 0.3));
            assertTrue(Reading.isOff(first) || first == Reading.NOTHING || first >= 0 && first <= RANGE);
        }
    }

    @ParameterizedTest
    @EnumSource
    void everyKindMakesAFaultOfItself(FaultKind kind) {
        Fault fault = kind.createFault(kind.defaultValue());
        assertEquals(kind, fault.kind());
        assertEquals(kind.takesValue() ? kind.defaultValue() : 0, fault.value());
    }
}
