package faultline.engine.recording;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.CommandListener;
import faultline.engine.ControllerFactory;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.robot.Velocity;
import faultline.world.CommandResult;

/**
 * Records a run on the thread of the run. Frames are created only about sixty times a second, and events between two
 * frames must not be lost.
 */
public final class Recorder implements TickObserver, CommandListener {

    private final SimulationSetup setup;
    private final int sensors;
    private final float[] values;
    private final TraceRecorder trace;
    private final EventRecorder events = new EventRecorder();
    private final DiagnosisRecorder diagnosis = new DiagnosisRecorder(events::add);
    private final StateTallyRecorder states = new StateTallyRecorder();
    private final KeyframeRecorder keyframes = new KeyframeRecorder();
    private final HashTraceRecorder hashes = new HashTraceRecorder();
    private Telemetry lastTelemetry;
    private boolean collided;

    /**
     * Creates a recorder of a run that has not started.
     *
     * @param setup the setup of the run
     */
    public Recorder(SimulationSetup setup) {
        this.setup = setup;
        sensors = setup.robot().sensors().size();
        values = new float[TraceChannels.count(sensors)];
        trace = new TraceRecorder(values.length);
        lastTelemetry = Telemetry.ofState(ControllerFactory.initialState(setup.controller()));
        states.start(lastTelemetry.state());
    }

    @Override
    public void commandHandled(CommandResult result) {
        double time = setup.timeOf(result.tick());
        events.add(result.refusal()
                .<RunEvent>map(reason -> new RunEvent.CommandRefused(result.tick(), time, result.command(), reason))
                .orElseGet(() -> new RunEvent.CommandExecuted(result.tick(), time, result.effect())));
    }

    @Override
    public void observe(Simulation simulation) {
        diagnosis.observe(simulation);
        recordState(simulation);
        recordCollision(simulation);
        recordMotion(simulation);
        recordSensors(simulation);
        trace.add(values);
        hashes.add(simulation.trajectoryHash());
        if (keyframes.isDue(simulation.ticks())) {
            keyframes.add(simulation.frame());
        }
    }

    private void recordState(Simulation simulation) {
        Telemetry now = simulation.telemetry();
        if (now.transitions() != lastTelemetry.transitions() || !now.state().equals(lastTelemetry.state())) {
            events.add(new RunEvent.StateChanged(
                    simulation.ticks(),
                    setup.timeOf(simulation.ticks()),
                    lastTelemetry.state(),
                    now.state(),
                    now.condition()));
            states.recordTransition(lastTelemetry.state(), now.state());
            recordTiming(simulation, now);
        }
        lastTelemetry = now;
        if (simulation.ticks() > 0) {
            states.tick();
        }
    }

    private void recordTiming(Simulation simulation, Telemetry now) {
        if (now.state() == FollowerState.ALIGN
                && Double.isFinite(now.edges().tP())
                && simulation.controllerSpec() instanceof ControllerSpec.WallFollowing follower) {
            events.add(new RunEvent.AlignmentTimed(
                    simulation.ticks(), setup.timeOf(simulation.ticks()), now.edges(), follower.timingRule()));
        }
    }

    private void recordCollision(Simulation simulation) {
        if (!collided && simulation.collision().isPresent()) {
            collided = true;
            events.add(new RunEvent.Collided(
                    simulation.ticks(), simulation.collision().get()));
        }
    }

    private void recordMotion(Simulation simulation) {
        values[TraceChannels.WANTED_DISTANCE] = (float) lastTelemetry.wall().wantedDistance();
        values[TraceChannels.MEASURED_DISTANCE] = (float) lastTelemetry.wall().measuredDistance();
        values[TraceChannels.PROPORTIONAL] = (float) lastTelemetry.wall().proportional();
        values[TraceChannels.DERIVATIVE] = (float) lastTelemetry.wall().derivative();
        values[TraceChannels.LEFT_VOLTS] = (float) simulation.leftVolts();
        values[TraceChannels.RIGHT_VOLTS] = (float) simulation.rightVolts();
        double heading = simulation.pose().heading();
        values[TraceChannels.HEADING] = (float) heading;
        values[TraceChannels.HEADING_REST] = (float) (heading - (float) heading);
        Velocity commanded = simulation.commandedVelocity();
        values[TraceChannels.COMMANDED_VELOCITY] = (float) commanded.linear();
        values[TraceChannels.COMMANDED_TURN_RATE] = (float) commanded.angular();
        Velocity velocity = simulation.velocity();
        values[TraceChannels.VELOCITY] = (float) velocity.linear();
        values[TraceChannels.TURN_RATE] = (float) velocity.angular();
    }

    private void recordSensors(Simulation simulation) {
        for (int i = 0; i < sensors; i++) {
            values[TraceChannels.trueReading(i)] = (float) simulation.trueReading(i);
            values[TraceChannels.reportedReading(i)] = (float) simulation.reportedReading(i);
        }
    }

    /** {@return an immutable view of everything recorded so far} */
    public Recording view() {
        return new Recording(trace.view(), events.view(), states.view(), keyframes.view(), hashes.view());
    }
}
