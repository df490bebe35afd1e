package faultline.gui.timeline;

import faultline.engine.SimulationSetup;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.Notes;
import faultline.gui.action.UiAction;
import faultline.gui.document.RunNavigator;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.text.Messages;
import java.awt.event.KeyEvent;
import java.util.OptionalLong;

/**
 * The actions of the time line: those that move the run to the next or previous mark, and those that zoom the lanes. If
 * the user moves or restarts the run, the lanes show its new time.
 */
public final class TimelineActions implements WorkspaceListener {

    private final TimelinePanel timeline;
    private final RunNavigator navigator;
    private final Notes notes;
    private final UiAction nextEvent =
            UiAction.of("nextEvent", this::goToNext).withAccelerator(Keystrokes.character('>'));
    private final UiAction previousEvent =
            UiAction.of("previousEvent", this::goToPrevious).withAccelerator(Keystrokes.character('<'));
    private final UiAction zoomIn =
            UiAction.of("lanesZoomIn", () -> zoom(1)).withAccelerator(Keystrokes.character('+'));
    private final UiAction zoomOut =
            UiAction.of("lanesZoomOut", () -> zoom(-1)).withAccelerator(Keystrokes.character('-'));
    private final UiAction showAll =
            UiAction.of("lanesWhole", this::showAll).withAccelerator(Keystrokes.unmodified(KeyEvent.VK_W));

    /** The last note about a mark that the run was moved to, empty before. */
    private String eventNote = "";

    /** Creates the actions of a time line, disabled before there is a run. */
    public TimelineActions(TimelinePanel timeline, RunNavigator navigator, Notes notes) {
        this.timeline = timeline;
        this.navigator = navigator;
        this.notes = notes;
        timeline.zoom().addListener(this::updateZoom);
        timeline.addLanesListener(this::updateZoom);
        update(0);
    }

    public void addTo(ActionRegistry actions) {
        actions.add(previousEvent);
        actions.add(nextEvent);
        actions.add(zoomIn);
        actions.add(zoomOut);
        actions.add(showAll);
    }

    /** Enables the actions that do something at a tick. */
    public void update(long tick) {
        nextEvent.setEnabled(next(tick).isPresent());
        previousEvent.setEnabled(timeline.stops().before(tick).isPresent());
        updateZoom();
    }

    private void updateZoom() {
        boolean shown = timeline.areLanesShown() && timeline.lanes().isEnabled();
        boolean whole = timeline.zoom().axis().isWhole();
        zoomIn.setEnabled(shown && timeline.zoom().canZoomIn());
        zoomOut.setEnabled(shown && !whole);
        showAll.setEnabled(shown && !whole);
    }

    private OptionalLong next(long tick) {
        return timeline.stops().after(tick, timeline.bar().end());
    }

    private void goToNext() {
        next(navigator.currentTick()).ifPresent(this::goTo);
    }

    private void goToPrevious() {
        timeline.stops().before(navigator.currentTick()).ifPresent(this::goTo);
    }

    /** Moves the run to a mark; does nothing while it is being moved. */
    private void goTo(long tick) {
        if (navigator.seekIfIdle(tick)) {
            eventNote = Messages.get(
                    "note.event", timeline.tickText(tick), timeline.stops().text(tick));
            notes.show(eventNote);
        }
    }

    @Override
    public void seekStarted(long tick) {
        timeline.showTick(tick);
    }

    @Override
    public void scenarioRestarted(SimulationSetup before) {
        timeline.showTick(0);
        notes.remove(eventNote);
    }

    private void zoom(int steps) {
        timeline.zoom().zoomAbout(steps, timeline.lanes().now());
    }

    private void showAll() {
        timeline.zoom().showAll();
    }
}
