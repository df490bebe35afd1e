package faultline.gui.bar;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.ObstacleActions;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import java.awt.Dimension;
import javax.swing.AbstractButton;
import javax.swing.JToolBar;

/** A column of buttons, one for each shape that can be placed on the canvas; they are lower on a small screen. */
public final class ObstaclePalette extends JToolBar {

    /** The height of an icon with a little room, pixels. */
    private static final int MIN_BUTTON_HEIGHT = 22;

    /** Creates a column, given the actions, which include one for each shape. */
    public ObstaclePalette(ActionRegistry actions) {
        super(VERTICAL);
        setFloatable(false);
        UiText.name(this, "palette");
        for (String key : ObstacleActions.PALETTE_KEYS) {
            add(RefreshSteps.add(ToolBar.createToolButton(actions.get(key)), ObstaclePalette::letShrink));
        }
    }

    private static void letShrink(AbstractButton button) {
        button.setMinimumSize(new Dimension(button.getPreferredSize().width, MIN_BUTTON_HEIGHT));
    }
}
