package faultline.gui.timeline;

import faultline.gui.action.ContextMenu;
import faultline.gui.theme.UiText;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorSide;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/** The actions on the selected lane and item. */
final class LaneActions {

    /** The number of steps that a new fault lasts initially. */
    private static final int NEW_STEPS = 20;

    private final LaneView view;
    private final TimelineEditor editor;
    /** The last faults of sensors and of motors, which have the kind and the numbers of a new one. */
    private final List<Command> lastFaults = new ArrayList<>(List.of(
            new Command.InjectFault("", FaultKind.STUCK.createFault(FaultKind.STUCK.defaultValue())),
            new Command.InjectMotorFault(
                    MotorSide.LEFT, MotorFaultKind.WEAK.createFault(MotorFaultKind.WEAK.defaultValue()))));

    /** The context menu that was shown last, null before the first. */
    private JPopupMenu shownMenu;

    LaneActions(LaneView view, TimelineEditor editor) {
        this.view = view;
        this.editor = editor;
    }

    /** Edits the selected item; without one, adds one at the present time. */
    void editOrAdd() {
        view.selectedItem().ifPresentOrElse(this::edit, () -> addItem(view.now()));
    }

    private void edit(TimelineItem item) {
        showDialog(item).ifPresent(changed -> {
            // The timeline may have changed while the dialog was open.
            view.updateModel();
            int index = view.indexOf(item);
            if (index != LaneLayout.NONE) {
                editor.replace(index, changed);
                view.select(changed);
            }
        });
    }

    private Optional<TimelineItem> showDialog(TimelineItem item) {
        return ItemDialog.showDialog(view, view.allLanes(), item, editor.robot(), editor.tickLength(), newLength());
    }

    /** Asks for a new fault in the selected lane that starts at a time; in the last one, for a controller. */
    void addItem(double start) {
        if (view.selectedLane().equals(Lane.OTHER)) {
            addController(start);
        } else {
            addFault(start);
        }
    }

    /** Asks for the settings that the controller gets at a time. */
    private void addController(double start) {
        double time = editor.roundToTick(start);
        editor.controllerAt(time)
                .map(controller -> TimelineItem.from(new Command.ConfigureController(controller), time))
                .ifPresent(this::add);
    }

    /** Asks for a new fault in the selected lane that starts at a time. */
    private void addFault(double start) {
        newFault(start, editor.roundToTick(start + newLength())).ifPresent(this::add);
    }

    /** Returns the length of a fault that gets its first end, seconds. */
    private double newLength() {
        return NEW_STEPS * step();
    }

    /** Returns a fault in the selected lane; empty in the lane of everything else. */
    Optional<TimelineItem> newFault(double start, double end) {
        return lastFaults.stream()
                .map(fault -> new TimelineItem(fault, start, end).inLane(view.selectedLane()))
                .filter(item -> item.lane().equals(view.selectedLane()))
                .findFirst();
    }

    /** Asks for the details of a new item and adds it. */
    void add(TimelineItem item) {
        Optional<TimelineItem> wanted = showDialog(item);
        view.setPreview(null);
        wanted.ifPresent(this::addAndSelect);
    }

    private void addAndSelect(TimelineItem item) {
        lastFaults.replaceAll(fault -> fault.getClass() == item.command().getClass() ? item.command() : fault);
        editor.add(item, view.selectedItem().orElse(null));
        view.select(item);
    }

    /** Asks for the time at which the sensor of the selected lane is switched off and on again. */
    void addSwitch(double start) {
        if (view.selectedLane() instanceof Lane.SensorLane sensor) {
            add(TimelineItem.from(new Command.SwitchSensor(sensor.id(), false), start));
        }
    }

    void delete() {
        if (view.selection() != LaneLayout.NONE) {
            editor.remove(view.selection());
            view.select(view.lane(), LaneLayout.NONE);
        }
    }

    void copy() {
        if (view.selection() != LaneLayout.NONE) {
            editor.copy(view.selection());
        }
    }

    void cut() {
        copy();
        delete();
    }

    /**
     * Adds the copied item at a time: an interval in the selected lane, a mark in its own one. Reports if an interval
     * cannot be in that lane, or if the scenario lacks the subject of the item.
     */
    void paste(double start) {
        copiedItem(start).ifPresent(item -> {
            if (!editor.hasSubjectOf(item)) {
                editor.reportNoSubject(item);
            } else if (isMisplaced(item)) {
                editor.reportMisplaced(item, view.selectedLane());
            } else {
                addAndSelect(item);
            }
        });
    }

    /** Returns whether the selected lane cannot have an interval. */
    private boolean isMisplaced(TimelineItem item) {
        return item.isInterval() && !item.lane().equals(view.selectedLane());
    }

    private Optional<TimelineItem> copiedItem(double start) {
        return editor.clipboard()
                .map(item -> startingAt(item, editor.roundToTick(start)))
                .map(item -> item.inLane(view.selectedLane()));
    }

    /** Adds a copy of the selected item directly after it. */
    void duplicate() {
        view.selectedItem()
                .map(item -> startingAt(
                        item,
                        editor.roundToTick(item.isOpen() || !item.isInterval() ? item.start() + step() : item.end())))
                .ifPresent(this::addAndSelect);
    }

    /** Returns an item of the same length, in ticks, that starts at another time. */
    private TimelineItem startingAt(TimelineItem item, double start) {
        return withEnds(item, start, item.end() + start - item.start());
    }

    /** Moves the start and the end of the selected item by a number of steps each. */
    void move(int startSteps, int endSteps) {
        view.selectedItem().ifPresent(item -> {
            double start = startSteps == 0 ? item.start() : editor.roundToTick(item.start() + startSteps * step());
            double end = item.end() + (startSteps == endSteps ? start - item.start() : endSteps * step());
            TimelineItem moved = withEnds(item, start, end);
            editor.replace(view.selection(), moved);
            view.select(moved);
            view.zoom().showTime(startSteps == 0 ? moved.end() : moved.start());
        });
    }

    /** Returns an item with other times, at least a tick long. */
    TimelineItem withEnds(TimelineItem item, double start, double end) {
        double tick = editor.tickLength();
        double latest = item.isInterval() ? Math.max(0, item.end() - tick) : start;
        double newStart = start == item.start() || end != item.end() ? start : Math.min(start, latest);
        double newEnd = Math.max(end, newStart + tick);
        return item.withTimes(
                newStart == item.start() ? newStart : editor.roundToTick(newStart),
                newEnd == item.end() || Double.isInfinite(newEnd) ? newEnd : editor.roundToTick(newEnd));
    }

    double step() {
        return view.axis().step(editor.tickLength());
    }

    /** Shows the context menu of the selected lane and item. */
    void showMenu(Component invoker, int x, int y, double time) {
        shownMenu = createMenu(time);
        ContextMenu.show(shownMenu, invoker, x, y);
    }

    boolean isMenuShown() {
        return shownMenu != null && shownMenu.isVisible();
    }

    /** Returns the context menu of the selected lane and item; new items start at a time. */
    JPopupMenu createMenu(double time) {
        JPopupMenu menu = new JPopupMenu();
        boolean item = view.selection() != LaneLayout.NONE;
        boolean sensorLane = view.selectedLane() instanceof Lane.SensorLane;
        add(menu, "timeline.menu.edit", item, this::editOrAdd);
        add(menu, "timeline.menu.fault", view.selectedLane() != Lane.OTHER, () -> addFault(time));
        add(menu, "timeline.menu.switch", sensorLane, () -> addSwitch(time));
        boolean other = view.selectedLane().equals(Lane.OTHER);
        add(
                menu,
                "timeline.menu.controller",
                other && editor.controllerAt(time).isPresent(),
                () -> addController(time));
        menu.addSeparator();
        add(menu, "timeline.menu.cut", item, this::cut);
        add(menu, "timeline.menu.copy", item, this::copy);
        boolean pasteable = copiedItem(time)
                .filter(copied -> editor.hasSubjectOf(copied) && !isMisplaced(copied))
                .isPresent();
        add(menu, "timeline.menu.paste", pasteable, () -> paste(time));
        add(menu, "timeline.menu.duplicate", item, this::duplicate);
        add(menu, "timeline.menu.delete", item, this::delete);
        return menu;
    }

    private static void add(JPopupMenu menu, String key, boolean enabled, Runnable action) {
        JMenuItem item = UiText.menuText(new JMenuItem(), key);
        item.setEnabled(enabled);
        item.addActionListener(event -> action.run());
        menu.add(item);
    }
}
