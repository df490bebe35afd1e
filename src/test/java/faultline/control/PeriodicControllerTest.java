package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.wallfollower.Observations;
import faultline.robot.WheelSpeeds;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PeriodicControllerTest {

    private final List<Long> decisionTicks = new ArrayList<>();

    /** Asks for decisions at ticks 3 to 12 and returns the left voltages, which say at what tick each was made. */
    private List<Double> decide(double period) {
        Controller inner = observation -> {
            decisionTicks.add(observation.tick());
            return new Decision(observation.tick(), 0, Telemetry.ofState(ControllerState.of("TEST")));
        };
        PeriodicController periodic = new PeriodicController(inner, period);
        List<Double> volts = new ArrayList<>();
        for (long tick = 3; tick <= 12; tick++) {
            volts.add(periodic.decide(Observations.observation(tick, Map.of())).leftVolts());
        }
        return volts;
    }

    @Test
    void aPeriodOf0AsksEveryTick() {
        decide(0);
        assertEquals(10, decisionTicks.size());
    }

    @Test
    void betweenItsDecisionsTheLastOneHolds() {
        assertEquals(List.of(3.0, 3.0, 5.0, 5.0, 5.0, 5.0, 5.0, 10.0, 10.0, 10.0), decide(0.05));
        assertEquals(List.of(3L, 5L, 10L), decisionTicks);
    }

    @Test
    void aDecisionIsHeldOnlyBetweenTwoThatAreDue() {
        Decision decision = new Decision(1, 2, Telemetry.ofState(ControllerState.of("TEST")));
        PeriodicController periodic = new PeriodicController(observation -> decision, 0.05);
        assertNull(periodic.heldDecision(3, 0.01), "before the first");
        periodic.decide(Observations.observation(3, Map.of()));
        assertEquals(decision, periodic.heldDecision(4, 0.01));
        assertNull(periodic.heldDecision(5, 0.01), "the next one is due");
    }

    @Test
    void constantVoltagesAreDecidedOnce() {
        PeriodicController periodic =
                new PeriodicController(new ControllerSpec.Drive(1, 2), settings -> observation -> {
                    decisionTicks.add(observation.tick());
                    return new Decision(1, 2, Telemetry.ofState(ControllerState.of("DRIVE")));
                });
        for (long tick = 3; tick <= 1000; tick++) {
            assertEquals(
                    2, periodic.decide(Observations.observation(tick, Map.of())).rightVolts());
        }
        assertEquals(List.of(3L), decisionTicks);
        periodic.configure(new ControllerSpec.Drive(1, 2));
        assertNull(periodic.heldDecision(1001, 0.01), "the new controller has not decided");
    }

    @Test
    void settingsWithWhichAFollowerCanContinueDoNotReplaceIt() {
        List<ControllerSpec> created = new ArrayList<>();
        List<ControllerSpec> taken = new ArrayList<>();
        ControllerSpec.WallFollowing initial = ControllerSpec.WallFollowing.DEFAULT;
        PeriodicController periodic = new PeriodicController(initial, settings -> {
            created.add(settings);
            return new Controller() {
                @Override
                public Decision decide(Observation observation) {
                    return new Decision(0, 0, Telemetry.ofState(ControllerState.of("TEST")));
                }

                @Override
                public void configure(ControllerSpec.BuiltIn other) {
                    taken.add(other);
                }
            };
        });
        periodic.configure(initial.withDistance(0.4));
        periodic.configure(initial.withDistance(0.4).withPeriod(0.05));
        periodic.configure(new ControllerSpec.None());
        assertEquals(List.of(initial.withDistance(0.4)), taken);
        assertEquals(List.of(initial, initial.withDistance(0.4).withPeriod(0.05), new ControllerSpec.None()), created);
    }

    /** A controller with constant voltages that records how it begins. */
    private static final class Mover implements Successor {

        private final double volts;
        private final List<String> begun = new ArrayList<>();

        Mover(double volts) {
            this.volts = volts;
        }

        @Override
        public void begin(long tick, WheelSpeeds wheels) {
            begun.add(tick + " " + wheels);
        }

        @Override
        public Decision decide(Observation observation) {
            return new Decision(volts, 2 * volts, Telemetry.ofState(ControllerState.of("TEST")));
        }
    }

    /** The motors of the robot follow at once, at 0.1 m/s per volt. */
    @Test
    void aControllerThatReplacesAnotherOneLearnsHowFastTheWheelsTurn() {
        List<Mover> movers = new ArrayList<>();
        ControllerSpec.WallFollowing follower = ControllerSpec.WallFollowing.DEFAULT.withPeriod(0.05);
        PeriodicController periodic = new PeriodicController(follower, settings -> {
            movers.add(new Mover(movers.size() + 1));
            return movers.get(movers.size() - 1);
        });
        for (long tick = 0; tick < 20; tick++) {
            if (tick == 1) {
                periodic.configure(follower.withSide(WallSide.RIGHT));
            } else if (tick == 8) {
                periodic.configure(new ControllerSpec.Drive(1, 2));
            } else if (tick == 17) {
                periodic.configure(follower);
                periodic.configure(follower.withDiagnosis(false));
            }
            periodic.decide(Observations.observation(tick, Map.of()));
        }
        assertEquals(
                List.of(
                        List.of(),
                        List.of(),
                        List.of("8 " + new WheelSpeeds(0.1 * 2, 0.1 * 4)),
                        List.of(),
                        List.of("17 " + new WheelSpeeds(0.1 * 3, 0.1 * 6))),
                movers.stream().map(mover -> mover.begun).toList(),
                "the first one, and one that replaces it in the first tick, begin at rest");
    }

    /** Constant voltages are decided once, at tick 0. */
    @Test
    void aControllerThatReplacesConstantVoltagesLearnsHowFastTheWheelsTurn() {
        List<Mover> movers = new ArrayList<>();
        PeriodicController periodic = new PeriodicController(new ControllerSpec.Drive(1, 2), settings -> {
            movers.add(new Mover(1));
            return movers.get(movers.size() - 1);
        });
        for (long tick = 0; tick < 20; tick++) {
            if (tick == 10) {
                periodic.configure(ControllerSpec.WallFollowing.DEFAULT);
            }
            periodic.decide(Observations.observation(tick, Map.of()));
        }
        assertEquals(List.of("10 " + new WheelSpeeds(0.1, 0.2)), movers.get(1).begun);
    }

    /** A controller that keeps what is called and can fail to close. */
    @SuppressWarnings("try") // It may also be interrupted.
    private static final class Recording implements Controller, AutoCloseable {

        private final List<String> calls = new ArrayList<>();
        private Exception failure;

        @Override
        public Decision decide(Observation observation) {
            return new Decision(0, 0, Telemetry.ofState(ControllerState.of("TEST")));
        }

        @Override
        public void configure(ControllerSpec.BuiltIn settings) {
            calls.add("configure " + settings);
        }

        @Override
        public void close() throws Exception {
            calls.add("close");
            if (failure != null) {
                throw failure;
            }
        }
    }

    @Test
    void aControllerWithoutAFactoryGetsItsSettingsAndIsClosed() {
        Recording inner = new Recording();
        PeriodicController periodic = new PeriodicController(inner, 0.05);
        ControllerSpec.Drive drive = new ControllerSpec.Drive(1, 2);
        periodic.configure(drive);
        periodic.close();
        assertEquals(List.of("configure " + drive, "close"), inner.calls);
    }

    @Test
    void aControllerThatNeedsNoClosingIsLeftAlone() {
        new PeriodicController(observation -> null, 0.05).close();
    }

    @Test
    void aFailureToCloseIsReportedWithItsCause() {
        Recording inner = new Recording();
        inner.failure = new IOException("the link is down");
        IllegalStateException e =
                assertThrows(IllegalStateException.class, () -> new PeriodicController(inner, 0.05).close());
        assertSame(inner.failure, e.getCause());
        assertEquals("the controller cannot be closed", e.getMessage());
        assertFalse(Thread.interrupted());
    }

    @Test
    void aThreadThatIsInterruptedWhileItClosesRemainsInterrupted() {
        Recording inner = new Recording();
        inner.failure = new InterruptedException();
        assertThrows(IllegalStateException.class, () -> new PeriodicController(inner, 0.05).close());
        assertTrue(Thread.interrupted());
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "0.004, 1", "0.01, 1", "0.02, 2", "0.026, 3", "0.05, 5"})
    void aPeriodIsWholeTicksAndAtLeastOne(double period, long ticks) {
        assertEquals(ticks, PeriodicController.ticksPerPeriod(period, 0.01));
    }
}
