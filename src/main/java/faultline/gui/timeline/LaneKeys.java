package faultline.gui.timeline;

import faultline.gui.theme.KeyBindings;
import java.util.List;

/**
 * The keys of the lanes: arrow keys select a lane and an item; with Shift they move the end of the item, with Alt its
 * start, with the menu modifier both. Enter edits.
 */
final class LaneKeys {

    private final LaneView view;
    private final LaneActions actions;
    private final LaneMouse mouse;

    LaneKeys(LaneView view, LaneActions actions, LaneMouse mouse) {
        this.view = view;
        this.actions = actions;
        this.mouse = mouse;
    }

    void install() {
        bind("UP", () -> selectLane(view.lane() - 1));
        bind("DOWN", () -> selectLane(view.lane() + 1));
        bind("LEFT", () -> selectItem(-1));
        bind("RIGHT", () -> selectItem(1));
        bind("shift LEFT", () -> actions.move(0, -1));
        bind("shift RIGHT", () -> actions.move(0, 1));
        bind("alt LEFT", () -> actions.move(-1, 0));
        bind("alt RIGHT", () -> actions.move(1, 0));
        bind("menu LEFT", () -> actions.move(-1, -1));
        bind("menu RIGHT", () -> actions.move(1, 1));
        bind("ENTER", actions::editOrAdd);
        bind("INSERT", () -> actions.addItem(view.now()));
        bind("DELETE", actions::delete);
        bind("BACK_SPACE", actions::delete);
        bind("menu C", actions::copy);
        bind("menu X", actions::cut);
        bind("menu V", () -> actions.paste(view.now()));
        bind("menu D", actions::duplicate);
        KeyBindings.bind(view, "ESCAPE", this::escape);
        // Undo in the middle of a drag cancels it instead of undoing an edit.
        KeyBindings.bind(view, "menu Z", mouse::isDragging, mouse::cancelDrag);
        bind("CONTEXT_MENU", this::showMenu);
        bind("shift F10", this::showMenu);
    }

    /** Binds a key to an action on the newest timeline; during a drag it has no effect. */
    private void bind(String key, Runnable action) {
        KeyBindings.bind(view, key, () -> {
            view.updateModel();
            if (!mouse.isDragging()) {
                action.run();
            }
        });
    }

    private void selectLane(int lane) {
        int last = view.lanes().lanes().size() - 1;
        view.select(Math.max(0, Math.min(last, lane)), LaneLayout.NONE);
    }

    /** Selects the next item of the lane, or the previous one. */
    private void selectItem(int step) {
        List<Integer> items = view.lanes().itemsIn(view.lane());
        if (!items.isEmpty()) {
            int current = items.indexOf(view.selection());
            int next = current < 0 && step < 0 ? items.size() - 1 : current + step;
            view.select(view.lane(), items.get(Math.max(0, Math.min(items.size() - 1, next))));
        }
    }

    private void escape() {
        mouse.cancelDrag();
        view.select(view.lane(), LaneLayout.NONE);
    }

    private void showMenu() {
        LaneLayout lanes = view.lanes();
        double x = lanes.axis().x(view.selectedItem().map(TimelineItem::start).orElse(view.now()));
        double shown = Math.max(lanes.axis().left(), Math.min(lanes.axis().right(), x));
        actions.showMenu(view, (int) shown, lanes.laneTop(view.lane()), view.now());
    }
}
