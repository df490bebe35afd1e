package faultline.gui.window;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.ObstacleActions;
import faultline.gui.theme.UiText;
import javax.swing.JToolBar;

/** A column of buttons, one for each shape that can be placed on the canvas, low enough for a small screen. */
final class ObstaclePalette extends JToolBar {

    ObstaclePalette(ActionRegistry actions) {
        super(VERTICAL);
        setFloatable(false);
        UiText.name(this, "palette");
        for (String key : ObstacleActions.PALETTE_KEYS) {
            add(ToolBar.createToolButton(actions.get(key)));
        }
    }
}
