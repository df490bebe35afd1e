package faultline.engine;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.BuiltInCases;
import faultline.control.ControllerSpec.ControllerCases;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.PeriodicController;
import faultline.control.RecordedController;
import faultline.control.Telemetry;
import faultline.control.ladder.FaultTolerantFollower;
import faultline.control.wallfollower.WallFollower;
import faultline.world.Command;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;

/** Creates controllers from their specifications. */
public final class ControllerFactory {

    /** The state of a controller that is not part of the program until it names one. */
    private static final ControllerState FOREIGN_STATE = ControllerState.of("EXTERN");

    private ControllerFactory() {}

    /**
     * {@return a new controller for a run} One that is {@link AutoCloseable} belongs to the caller.
     *
     * @param setup the setup of the run
     * @throws RunFailedException if it is not part of the program and cannot be started
     */
    public static Controller create(SimulationSetup setup) {
        ControllerSpec spec = setup.controller();
        if (spec instanceof ControllerSpec.Chosen chosen) {
            long periodTicks = PeriodicController.ticksPerPeriod(spec.period(), setup.dt());
            ControllerSource.RunConditions run = new ControllerSource.RunConditions(
                    setup.seed(),
                    setup.dt(),
                    periodTicks,
                    setup.duration(),
                    setup.robot().believed());
            return new PeriodicController(chosen.source().start(run), spec.period());
        }
        return create(spec);
    }

    /** Returns the mode in which the controller of a run is called if the caller prefers a mode. */
    static ControllerMode mode(ControllerSpec spec, ControllerMode preferred) {
        if (spec instanceof ControllerSpec.Chosen chosen) {
            return chosen.source().limitsAnswerTime() ? ControllerMode.DIRECT : ControllerMode.OWN_THREAD;
        }
        return spec instanceof ControllerSpec.Provided ? ControllerMode.OWN_THREAD : preferred;
    }

    /**
     * {@return a new controller in its initial state; a controller of the program can get other settings during a run}
     *
     * @param spec the choice of the controller and its settings
     */
    public static Controller create(ControllerSpec spec) {
        return spec.match(new ControllerCases<>(
                builtIn -> new PeriodicController(builtIn, ControllerFactory::createBuiltIn),
                extern -> observation -> failNotChosen(),
                provided -> new PeriodicController(
                        ControllerProviders.create(provided.name(), provided.settings()), provided.period()),
                chosen -> observation -> failNotChosen(),
                recorded -> new RecordedController(recorded, FOREIGN_STATE)));
    }

    /** Returns a controller of the program that decides on every observation. */
    private static Controller createBuiltIn(ControllerSpec.BuiltIn spec) {
        return spec.matchBuiltIn(new BuiltInCases<>(
                none -> constant(none, 0, 0),
                drive -> constant(drive, drive.leftVolts(), drive.rightVolts()),
                follower -> follower.diagnosis() ? new FaultTolerantFollower(follower) : new WallFollower(follower)));
    }

    private static Controller constant(ControllerSpec.BuiltIn spec, double leftVolts, double rightVolts) {
        Decision decision = new Decision(leftVolts, rightVolts, Telemetry.ofState(initialState(spec)));
        return observation -> decision;
    }

    /**
     * Closes a controller that can be closed.
     *
     * @param controller a controller that this class has created
     * @param spec its specification
     * @throws RunFailedException if it throws an exception, or is in Java and does not return
     */
    public static void close(Controller controller, ControllerSpec spec) {
        close(controller, spec, ControllerThread.TIMEOUT);
    }

    /** Closes a controller that can be closed; the time-out for one in Java is in seconds. */
    static void close(Controller controller, ControllerSpec spec, double timeout) {
        if (!(controller instanceof PeriodicController closeable)) {
            return;
        }
        try {
            if (mode(spec, ControllerMode.DIRECT) == ControllerMode.DIRECT) {
                close(closeable);
            } else {
                ControllerThread.call(timeout, Executors.callable(() -> close(closeable)));
            }
        } catch (ExecutionException e) {
            throw RunFailedException.ofCall(e, RunProblem.NOT_CLOSED);
        } catch (TimeoutException e) {
            throw new RunFailedException(RunProblem.NOT_CLOSED.with(ControllerThread.silence("close", timeout)), e);
        }
    }

    private static void close(PeriodicController closeable) {
        try {
            closeable.close();
        } catch (IllegalStateException e) {
            throw new RunFailedException(RunProblem.NOT_CLOSED.with(ExceptionText.of(e.getCause())), e.getCause());
        }
    }

    private static Decision failNotChosen() {
        throw new RunFailedException(RunProblem.NOT_CHOSEN.with(), null);
    }

    /**
     * {@return all states of a controller, the initial state first; empty for one that is not part of the program}
     *
     * @param spec the choice of the controller
     */
    public static List<ControllerState> states(ControllerSpec spec) {
        if (!(spec instanceof ControllerSpec.BuiltIn builtIn)) {
            return List.of();
        }
        return builtIn.matchBuiltIn(new BuiltInCases<>(
                none -> List.of(ControllerState.of("NONE")),
                drive -> List.of(ControllerState.of("DRIVE")),
                ControllerFactory::followerStates));
    }

    /**
     * {@return all states of the controllers that may drive in a run: of the first one and of those of the timeline,
     * the initial state first; empty if the first one is not part of the program, since the timeline cannot change it}
     *
     * @param setup the setup of the run
     */
    public static List<ControllerState> statesInRun(SimulationSetup setup) {
        List<ControllerState> first = states(setup.controller());
        if (first.isEmpty()) {
            return first;
        }
        Stream<ControllerState> later = setup.timeline().stream()
                .map(SimulationSetup.TimedCommand::command)
                .filter(Command.ConfigureController.class::isInstance)
                .flatMap(command -> states(((Command.ConfigureController) command).controller()).stream());
        return Stream.concat(first.stream(), later).distinct().toList();
    }

    private static List<ControllerState> followerStates(ControllerSpec.WallFollowing spec) {
        Stream<ControllerState> stop = spec.diagnosis() ? Stream.of(FaultTolerantFollower.STOP) : Stream.empty();
        return Stream.concat(Arrays.stream(FollowerState.values()), stop).toList();
    }

    /**
     * {@return the state that a controller starts in}
     *
     * @param spec the choice of the controller
     */
    public static ControllerState initialState(ControllerSpec spec) {
        return states(spec).stream().findFirst().orElse(FOREIGN_STATE);
    }
}
