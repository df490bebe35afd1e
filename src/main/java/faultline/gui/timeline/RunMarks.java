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
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * The marks on the time slider: collisions, corners, changed settings, the starts of faults, and the end of the
 * scenario. Together with the items of the lanes, these are the events to which the run can be moved.
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
        result.changes(items).forEach(result::addEvent);
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
        result.collisions()
                .forEach(collided -> result.marks.add(new SliderMark(
                        TimeBar.toSliderValue(collided.tick()),
                        MarkShape.DISC,
                        theme -> theme.palette().collision(),
                        EventText.sentence(collided))));
        return List.copyOf(result.marks);
    }

    /** Returns the marked events of the newest frame, and the starts and ends of all items. */
    static List<EventStops.Stop> stops(SessionFrame frame, List<TimelineItem> items, double dt) {
        RunMarks run = new RunMarks(frame, dt);
        List<EventStops.Stop> stops = new ArrayList<>();
        Stream.concat(run.changes(items), run.collisions())
                .map(event -> new EventStops.Stop(event.tick(), () -> EventText.sentence(event)))
                .forEach(stops::add);
        for (TimelineItem item : items) {
            stops.add(new EventStops.Stop(SimulationSetup.tickAt(item.start(), dt), () -> TimelineText.start(item)));
            if (item.isInterval() && !item.isOpen()) {
                stops.add(new EventStops.Stop(SimulationSetup.tickAt(item.end(), dt), () -> TimelineText.end(item)));
            }
        }
        return stops;
    }

    /** Returns the corners, and the changes of settings that are not items. */
    private Stream<RunEvent> changes(List<TimelineItem> items) {
        Set<Execution> planned = plannedChanges(items);
        return events().filter(
                        event -> event instanceof RunEvent.StateChanged change && change.to() == FollowerState.TURN
                                || event instanceof RunEvent.CommandExecuted done
                                        && CommandRole.isSettingChange(done.command())
                                        && !planned.contains(new Execution(done.command(), done.tick())));
    }

    private Stream<RunEvent> collisions() {
        return events().filter(RunEvent.Collided.class::isInstance);
    }

    private Stream<RunEvent> events() {
        EventLog log = frame.recording().events();
        return LongStream.range(log.firstIndex(), log.endIndex()).mapToObj(log::get);
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
