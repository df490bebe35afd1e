package faultline.gui.timeline;

import faultline.control.FollowerState;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.text.Messages;
import faultline.gui.theme.SliderMark;
import faultline.gui.theme.SliderMark.MarkShape;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The marks on the time slider: collisions, corners, changed settings, the starts of faults, and the end of the
 * scenario.
 */
final class RunMarks {

    private final List<SliderMark> marks = new ArrayList<>();
    private final SessionFrame frame;
    private final double dt;

    /** A command and the tick at which it is executed. */
    private record Execution(Command command, long tick) {}

    private RunMarks(SessionFrame frame, double dt) {
        this.frame = frame;
        this.dt = dt;
    }

    /** Returns the marks of the newest frame, later ones over earlier ones, up to the last tick of the scenario. */
    static List<SliderMark> of(SessionFrame frame, List<TimelineItem> items, long end, double dt) {
        RunMarks result = new RunMarks(frame, dt);
        EventLog log = frame.recording().events();
        Set<Execution> planned = result.plannedChanges(items);
        for (long i = log.firstIndex(); i < log.endIndex(); i++) {
            if (log.get(i) instanceof RunEvent.StateChanged change && change.to() == FollowerState.TURN
                    || log.get(i) instanceof RunEvent.CommandExecuted done
                            && CommandRole.isSettingChange(done.command())
                            && !planned.contains(new Execution(done.command(), done.tick()))) {
                result.addEvent(log.get(i));
            }
        }
        items.stream()
                .filter(item -> item.isInterval() || CommandRole.isSettingChange(item.command()))
                .forEach(result::addItem);
        if (end > 0) {
            result.marks.add(new SliderMark(
                    TimeBar.toSliderValue(end),
                    MarkShape.TICK,
                    theme -> theme.palette().text(),
                    Messages.get("time.end")));
        }
        for (long i = log.firstIndex(); i < log.endIndex(); i++) {
            if (log.get(i) instanceof RunEvent.Collided collided) {
                result.marks.add(new SliderMark(
                        TimeBar.toSliderValue(collided.tick()),
                        MarkShape.DISC,
                        theme -> theme.palette().collision(),
                        EventText.sentence(collided)));
            }
        }
        return List.copyOf(result.marks);
    }

    /** Returns the changes of settings that are marked as items. */
    private Set<Execution> plannedChanges(List<TimelineItem> items) {
        return items.stream()
                .filter(item -> CommandRole.isSettingChange(item.command()))
                .map(item -> new Execution(item.command(), SimulationSetup.tickAt(item.start(), dt)))
                .collect(Collectors.toSet());
    }

    private void addEvent(RunEvent event) {
        marks.add(new SliderMark(
                TimeBar.toSliderValue(event.tick()),
                MarkShape.TICK,
                theme -> theme.palette().muted(),
                EventText.sentence(event)));
    }

    private void addItem(TimelineItem item) {
        marks.add(new SliderMark(
                TimeBar.toSliderValue(SimulationSetup.tickAt(item.start(), dt)),
                MarkShape.TICK,
                theme -> item.isInterval()
                        ? item.colours(theme.palette(), sensorIndex(item)).outline()
                        : theme.palette().muted(),
                TimelineText.description(item)));
    }

    private int sensorIndex(TimelineItem item) {
        for (int i = 0; i < frame.snapshot().sensors().size(); i++) {
            if (item.lane()
                    .equals(new Lane.SensorLane(
                            frame.snapshot().sensors().get(i).spec().id()))) {
                return i;
            }
        }
        return 0;
    }
}
