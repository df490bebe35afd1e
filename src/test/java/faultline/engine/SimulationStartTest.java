package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.Telemetry;
import faultline.geometry.Pose;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A simulation that cannot start closes the controller that was started for it. */
class SimulationStartTest {

    private static final SimulationSetup ROOM =
            SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1.5, 0));

    private final AtomicInteger closed = new AtomicInteger();

    /** Ways to give no name, with what the error says. */
    private enum Name {
        THROWN("java.lang.IllegalStateException: no name", () -> {
            throw new IllegalStateException("no name");
        }),
        ABSENT("java.lang.NullPointerException: name", () -> null);

        private final String error;
        private final Supplier<String> supplier;

        Name(String error, Supplier<String> supplier) {
            this.error = error;
            this.supplier = supplier;
        }
    }

    private record Named(Supplier<String> supplier, AtomicInteger closed) implements Controller, AutoCloseable {
        @Override
        public Decision decide(Observation observation) {
            return new Decision(0, 0, Telemetry.ofState(ControllerState.of("TEST")));
        }

        @Override
        public String name() {
            return supplier.get();
        }

        @Override
        public void close() {
            closed.incrementAndGet();
        }
    }

    @ParameterizedTest
    @EnumSource
    void aControllerWithoutANameEndsTheRunWithASentenceAndIsClosed(Name name) {
        ControllerSource source = new ControllerSource() {
            @Override
            public Controller start(RunConditions run) {
                return new Named(name.supplier, closed);
            }

            @Override
            public boolean limitsAnswerTime() {
                return false;
            }
        };
        SimulationSetup setup = ROOM.withController(new ControllerSpec.Chosen(ROOM.controller(), source));
        RunFailedException failure =
                assertThrows(RunFailedException.class, () -> new Simulation(setup, ControllerMode.DIRECT));
        assertEquals("the controller broke at tick 0: " + name.error, failure.getMessage());
        assertEquals(1, closed.get());
    }
}
