package faultline.engine;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.PeriodicController;
import faultline.control.RecordedController;
import faultline.control.Telemetry;
import faultline.control.ladder.FaultTolerantFollower;
import faultline.control.wallfollower.WallFollower;
import java.util.Arrays;
import java.util.List;
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
                    setup.seed(), setup.dt(), periodTicks, setup.duration(), setup.robot());
            return new PeriodicController(chosen.source().start(run), spec.period());
        }
        return create(spec);
    }

    /** Returns where the controller of a run is called if the caller prefers a mode. */
    static ControllerMode mode(ControllerSpec spec, ControllerMode preferred) {
        if (spec instanceof ControllerSpec.Chosen chosen) {
            return chosen.source().limitsAnswerTime() ? ControllerMode.DIRECT : ControllerMode.OWN_THREAD;
        }
        return spec instanceof ControllerSpec.Provided ? ControllerMode.OWN_THREAD : preferred;
    }

    /**
     * {@return a new controller in its initial state; one of the program takes other settings during a run}
     *
     * @param spec the choice of the controller and its settings
     */
    public static Controller create(ControllerSpec spec) {
        return spec.accept(new Creator());
    }

    /**
     * {@return all states of a controller, the initial state first; empty for one that is not part of the program}
     *
     * @param spec the choice of the controller
     */
    public static List<ControllerState> states(ControllerSpec spec) {
        return spec instanceof ControllerSpec.BuiltIn builtIn ? builtIn.acceptBuiltIn(new StateLister()) : List.of();
    }

    /**
     * {@return the state that a controller starts in}
     *
     * @param spec the choice of the controller
     */
    public static ControllerState initialState(ControllerSpec spec) {
        return states(spec).stream().findFirst().orElse(FOREIGN_STATE);
    }

    /** Creates controllers. */
    private static final class Creator implements ControllerSpec.ControllerVisitor<Controller> {

        private static Controller periodic(ControllerSpec.BuiltIn spec) {
            return new PeriodicController(spec, settings -> settings.acceptBuiltIn(new DelegateCreator()));
        }

        @Override
        public Controller visit(ControllerSpec.None spec) {
            return periodic(spec);
        }

        @Override
        public Controller visit(ControllerSpec.Drive spec) {
            return periodic(spec);
        }

        @Override
        public Controller visit(ControllerSpec.WallFollowing spec) {
            return periodic(spec);
        }

        @Override
        public Controller visit(ControllerSpec.Extern spec) {
            return observation -> failNotChosen();
        }

        @Override
        public Controller visit(ControllerSpec.Provided spec) {
            Controller controller = ControllerProviders.create(spec.name(), spec.settings());
            return new PeriodicController(controller, spec.period());
        }

        @Override
        public Controller visit(ControllerSpec.Chosen spec) {
            return observation -> failNotChosen();
        }

        @Override
        public Controller visit(ControllerSpec.Recorded spec) {
            return new RecordedController(spec, FOREIGN_STATE);
        }

        private static Decision failNotChosen() {
            throw new RunFailedException(
                    "the scenario is driven by a controller from outside, and none was chosen", null);
        }
    }

    /** Creates controllers of the program that decide on every observation. */
    private static final class DelegateCreator implements ControllerSpec.BuiltInVisitor<Controller> {

        private static Controller constant(ControllerSpec.BuiltIn spec, double leftVolts, double rightVolts) {
            Decision decision = new Decision(leftVolts, rightVolts, Telemetry.ofState(initialState(spec)));
            return observation -> decision;
        }

        @Override
        public Controller visit(ControllerSpec.None spec) {
            return constant(spec, 0, 0);
        }

        @Override
        public Controller visit(ControllerSpec.Drive spec) {
            return constant(spec, spec.leftVolts(), spec.rightVolts());
        }

        @Override
        public Controller visit(ControllerSpec.WallFollowing spec) {
            return spec.diagnosis() ? new FaultTolerantFollower(spec) : new WallFollower(spec);
        }
    }

    /** Lists the states of controllers of the program. */
    private static final class StateLister implements ControllerSpec.BuiltInVisitor<List<ControllerState>> {

        @Override
        public List<ControllerState> visit(ControllerSpec.None spec) {
            return List.of(ControllerState.of("NONE"));
        }

        @Override
        public List<ControllerState> visit(ControllerSpec.Drive spec) {
            return List.of(ControllerState.of("DRIVE"));
        }

        @Override
        public List<ControllerState> visit(ControllerSpec.WallFollowing spec) {
            Stream<ControllerState> stop = spec.diagnosis() ? Stream.of(FaultTolerantFollower.STOP) : Stream.empty();
            return Stream.concat(Arrays.stream(FollowerState.values()), stop).toList();
        }
    }
}
