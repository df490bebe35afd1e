package faultline.gui.window;

import faultline.gui.text.Texts;
import javax.swing.Box;
import javax.swing.JToolBar;

/** A column of buttons, one for each shape that can be put on the canvas. */
final class ObstaclePalette extends JToolBar {

    private static final int GAP = 2;

    ObstaclePalette(UiActions actions) {
        super(VERTICAL);
        setFloatable(false);
        getAccessibleContext().setAccessibleName(Texts.text("palette"));
        for (String key : ObstacleActions.PALETTE) {
            add(ToolBar.toolButton(actions.get(key)));
            add(Box.createVerticalStrut(GAP));
        }
    }
}
