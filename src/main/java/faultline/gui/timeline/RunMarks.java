package faultline.gui.timeline;

import faultline.control.FollowerState;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.text.Messages;
import faultline.gui.theme.SliderMark;
import faultline.gui.theme.SliderMark.MarkShape;
import faultline.paint.surface.Palette;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * The marks on the time slider: collisions, also of the reference run, corners, changed settings, the starts of faults,
 * and the end of the scenario. Together with the items of the lanes, these are the events to which the run can be
 * moved.
 *
 * @param frame the newest frame
 * @param items the items of the timeline
 */
record RunMarks(SessionFrame frame, List<TimelineItem> items) {

    /** A command and the tick at which it is executed. */
    private record Execution(Command command, long tick) {}

    RunMarks {
        items = List.copyOf(items);
    }

    /**
     * Returns the marks of the newest frame, later ones over earlier ones, up to the last tick of the scenario, over
     * those of the contacts among some events of the reference run.
     */
    static List<SliderMark> of(
            SessionFrame frame, List<TimelineItem> items, long end, List<? extends RunEvent> ofGhost) {
        List<SliderMark> marks = new ArrayList<>();
        ofGhost.stream()
                .filter(RunEvent.GhostCollided.class::isInstance)
                .map(contact -> disc(contact, Palette::reference))
                .forEach(marks::add);
        marks.addAll(new RunMarks(frame, items).marks(end));
        return List.copyOf(marks);
    }

    private static SliderMark disc(RunEvent contact, Function<Palette, Color> colour) {
        return new SliderMark(
                TimeBar.toSliderValue(contact.tick()),
                MarkShape.DISC,
                theme -> colour.apply(theme.palette()),
                EventText.sentence(contact));
    }

    /** Returns the marked events of the newest frame, and the starts and ends of all items. */
    static List<EventStops.Stop> stops(SessionFrame frame, List<TimelineItem> items) {
        return new RunMarks(frame, items).stops();
    }

    private List<SliderMark> marks(long end) {
        List<SliderMark> marks = new ArrayList<>();
        changes().map(RunMarks::markOf).forEach(marks::add);
        items.stream()
                .filter(item -> item.isInterval() || CommandRole.isSettingChange(item.command()))
                .map(this::markOf)
                .forEach(marks::add);
        if (end > 0) {
            marks.add(new SliderMark(
                    TimeBar.toSliderValue(end),
                    MarkShape.TICK,
                    theme -> theme.palette().text(),
                    Messages.get("time.end")));
        }
        collisions().map(collided -> disc(collided, Palette::collision)).forEach(marks::add);
        return marks;
    }

    private List<EventStops.Stop> stops() {
        List<EventStops.Stop> stops = new ArrayList<>();
        Stream.concat(changes(), collisions())
                .map(event -> new EventStops.Stop(event.tick(), () -> EventText.sentence(event)))
                .forEach(stops::add);
        for (TimelineItem item : items) {
            stops.add(new EventStops.Stop(tickAt(item.start()), () -> TimelineText.start(item)));
            if (item.isInterval() && !item.isOpen()) {
                stops.add(new EventStops.Stop(tickAt(item.end()), () -> TimelineText.end(item)));
            }
        }
        return stops;
    }

    /** Returns the corners, and the changes of settings that are not items. */
    private Stream<RunEvent> changes() {
        Set<Execution> planned = plannedChanges();
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
    private Set<Execution> plannedChanges() {
        return items.stream()
                .filter(item -> CommandRole.isSettingChange(item.command()))
                .map(item -> new Execution(item.command(), tickAt(item.start())))
                .collect(Collectors.toSet());
    }

    /** Returns the tick at which a command of the timeline is executed; the time in seconds. */
    private long tickAt(double time) {
        return SimulationSetup.tickAt(time, frame.dt());
    }

    private static SliderMark markOf(RunEvent event) {
        return new SliderMark(
                TimeBar.toSliderValue(event.tick()),
                MarkShape.TICK,
                theme -> theme.palette().muted(),
                EventText.sentence(event));
    }

    private SliderMark markOf(TimelineItem item) {
        RobotSpec robot = frame.snapshot().robot();
        return new SliderMark(
                TimeBar.toSliderValue(tickAt(item.start())),
                MarkShape.TICK,
                theme -> item.isInterval()
                        ? item.colours(theme.palette(), robot).outline()
                        : theme.palette().muted(),
                TimelineText.description(item, frame.dt()));
    }
}
