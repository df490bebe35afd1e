package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.Telemetry;
import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;

/** A provider as a user writes one: turns right for as long as something is within range. */
public final class RightTurner implements ControllerProvider {

    /** What it does at a tick, to try controllers that misbehave. */
    static final Map<String, Runnable> DEEDS = Map.of(
            "error",
            () -> {
                throw new StackOverflowError("too deep");
            },
            "sleep",
            RightTurner::hang);

    /** The number of controllers that have been closed. */
    static final AtomicInteger CLOSED = new AtomicInteger();

    @Override
    public String name() {
        return "right-turner";
    }

    @Override
    public Controller create(Map<String, String> settings) {
        double volts = Double.parseDouble(settings.getOrDefault("volts", "3"));
        return new Turner(volts, settings.getOrDefault("deed", ""));
    }

    private record Turner(double volts, String deed) implements Controller, AutoCloseable {
        @Override
        public Decision decide(Observation observation) {
            if (observation.tick() == 7) {
                DEEDS.getOrDefault(deed, () -> {}).run();
            }
            boolean near = Arrays.stream(observation.readings()).anyMatch(Double::isFinite);
            Telemetry telemetry = Telemetry.ofState(ControllerState.of(near ? "NEAR" : "GO"));
            return new Decision(volts, near ? -volts : volts, telemetry);
        }

        @Override
        public void close() throws IOException {
            CLOSED.incrementAndGet();
            if (deed.equals("close")) {
                throw new IOException("still in use");
            }
        }
    }

    /** Hangs until it is interrupted. */
    private static void hang() {
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException e) {
            throw new IllegalStateException("woken", e);
        }
    }
}
