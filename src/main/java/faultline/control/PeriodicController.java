package faultline.control;

import faultline.control.ControllerSpec.BuiltIn;
import faultline.control.ControllerSpec.WallFollowing;
import java.util.function.Function;

/**
 * Lets a controller decide once per period; between its decisions the last one holds. It closes the controller if that
 * can be closed.
 *
 * <p>A controller of the program can get other settings between two decisions. It keeps its state if possible;
 * otherwise a new controller in its initial state replaces it, which learns how fast the wheels turn.
 */
public final class PeriodicController implements Controller, AutoCloseable {

    /** Creates a controller from other settings; null if the controller is never replaced. */
    private final Function<BuiltIn, Controller> factory;

    private BuiltIn settings;
    private Controller delegate;
    private double period;
    /** Null before the first decision of the present controller. */
    private Decision lastDecision;

    /** The wheels, the tick at which they were computed and the decision that has acted since, of any controller. */
    private final Odometer odometer = new Odometer();

    private long lastTick;
    private Decision acting;

    /**
     * Creates a controller that asks another at a period, rounded to whole ticks, at least one.
     *
     * @param delegate the other controller
     * @param period the period, in seconds, not negative
     */
    public PeriodicController(Controller delegate, double period) {
        this.factory = null;
        this.delegate = delegate;
        this.period = period;
    }

    /**
     * Creates a controller of the program, which asks another at the period of its settings.
     *
     * @param settings the settings
     * @param factory creates a controller from settings
     */
    public PeriodicController(BuiltIn settings, Function<BuiltIn, Controller> factory) {
        this.factory = factory;
        replace(settings);
    }

    private void replace(BuiltIn newSettings) {
        settings = newSettings;
        delegate = factory.apply(newSettings);
        // Constant voltages need only one decision.
        period = newSettings instanceof WallFollowing ? newSettings.period() : Double.POSITIVE_INFINITY;
        lastDecision = null;
    }

    @Override
    public Decision decide(Observation observation) {
        Decision held = heldDecision(observation.tick(), observation.dt());
        if (held == null) {
            if (factory != null) {
                updateWheels(observation);
            }
            lastDecision = delegate.decide(observation);
            acting = lastDecision;
        }
        return lastDecision;
    }

    private void updateWheels(Observation observation) {
        // One that replaces another in the first tick begins as if it were the first one.
        boolean replaced = lastDecision == null && acting != null && observation.tick() > 1;
        if (acting != null) {
            odometer.advance(
                    observation.robot(),
                    acting.leftVolts(),
                    acting.rightVolts(),
                    observation.dt(),
                    observation.tick() - lastTick);
        }
        lastTick = observation.tick();
        if (replaced && delegate instanceof Successor successor) {
            successor.begin(lastTick, odometer.wheels());
        }
    }

    /**
     * {@return the last decision if it holds at a tick too, otherwise null}
     *
     * @param tick the number of ticks that have passed
     * @param dt the length of a tick, in seconds, positive
     */
    public Decision heldDecision(long tick, double dt) {
        return tick % ticksPerPeriod(period, dt) == 0 ? null : lastDecision;
    }

    @Override
    public String name() {
        return delegate.name();
    }

    /**
     * Closes the controller if that can be closed.
     *
     * @throws IllegalStateException if it throws something, which is the cause
     */
    @Override
    public void close() {
        if (delegate instanceof AutoCloseable closeable) {
            try {
                closeable.close();
            } catch (Exception | Error e) {
                if (e instanceof InterruptedException) {
                    Thread.currentThread().interrupt();
                }
                // With a message of its own, because the text of an exception of a controller may not be readable.
                throw new IllegalStateException("the controller cannot be closed", e);
            }
        }
    }

    @Override
    public void configure(BuiltIn newSettings) {
        if (factory == null) {
            delegate.configure(newSettings);
        } else if (settings instanceof WallFollowing old
                && newSettings instanceof WallFollowing follower
                && old.canContinueWith(follower)) {
            delegate.configure(follower);
            settings = follower;
        } else {
            replace(newSettings);
        }
    }

    /**
     * {@return a period in whole ticks, at least one}
     *
     * @param period the period, in seconds, not negative
     * @param dt the length of a tick, in seconds, positive
     */
    public static long ticksPerPeriod(double period, double dt) {
        return Math.max(1, Math.round(period / dt));
    }
}
