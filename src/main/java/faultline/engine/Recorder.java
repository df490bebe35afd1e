package faultline.engine;

import faultline.control.Telemetry;
import faultline.engine.record.Channels;
import faultline.engine.record.EventRecorder;
import faultline.engine.record.HashRecorder;
import faultline.engine.record.RunEvent;
import faultline.engine.record.StateTallyRecorder;
import faultline.engine.record.TraceRecorder;
import faultline.world.Command;
import java.util.Optional;

/**
 * Remembers a run as it goes on, on its own thread: frames are looked at some sixty times a second, and what happens between two of them
 * must not be lost.
 */
final class Recorder implements TickObserver, CommandListener {

    private final double dt;
    private final int sensors;
    private final float[] values;
    private final TraceRecorder trace;
    private final EventRecorder events = new EventRecorder();
    private final StateTallyRecorder states = new StateTallyRecorder();
    private final KeyframeRecorder keyframes = new KeyframeRecorder();
    private final HashRecorder hashes = new HashRecorder();
    private Telemetry last;
    private boolean collided;

    /** Of a run that has not begun. */
    Recorder(Setup setup) {
        dt = setup.dt();
        sensors = setup.robot().sensors().size();
        values = new float[Channels.count(sensors)];
        trace = new TraceRecorder(values.length);
        last = Telemetry.named(setup.controller().firstState());
        states.start(last.state());
    }

    @Override
    public void commanded(long tick, Command command, Optional<String> refusal) {
        events.add(refusal.<RunEvent>map(why -> new RunEvent.Refused(tick, tick * dt, command, why))
                .orElseGet(() -> new RunEvent.Done(tick, tick * dt, command)));
    }

    @Override
    public void observe(Simulation simulation) {
        noteState(simulation);
        noteCollision(simulation);
        traceMotion(simulation);
        traceSensors(simulation);
        trace.add(values);
        hashes.add(simulation.trajectoryHash());
        if (keyframes.isDue(simulation.ticks())) {
            keyframes.add(simulation.frame());
        }
    }

    private void noteState(Simulation simulation) {
        Telemetry now = simulation.telemetry();
        if (now.transitions() != last.transitions()) {
            events.add(new RunEvent.Transition(simulation.ticks(), simulation.time(), last.state(), now.state(), now.condition()));
            states.move(last.state(), now.state());
        }
        last = now;
        if (simulation.ticks() > 0) {
            states.tick();
        }
    }

    private void noteCollision(Simulation simulation) {
        if (!collided && simulation.collision().isPresent()) {
            collided = true;
            events.add(new RunEvent.Collided(simulation.ticks(), simulation.collision().get()));
        }
    }

    private void traceMotion(Simulation simulation) {
        values[Channels.WANTED] = (float) last.wanted();
        values[Channels.MEASURED] = (float) last.measured();
        values[Channels.PROPORTIONAL] = (float) last.proportional();
        values[Channels.DERIVATIVE] = (float) last.derivative();
        values[Channels.LEFT_VOLTS] = (float) simulation.leftVolts();
        values[Channels.RIGHT_VOLTS] = (float) simulation.rightVolts();
        values[Channels.HEADING] = (float) simulation.pose().heading();
    }

    private void traceSensors(Simulation simulation) {
        for (int i = 0; i < sensors; i++) {
            values[Channels.truth(i)] = (float) simulation.trueReading(i);
            values[Channels.reported(i)] = (float) simulation.reportedReading(i);
        }
    }

    Recording view() {
        return new Recording(trace.view(), events.view(), states.view(), keyframes.view(), hashes.view());
    }
}
