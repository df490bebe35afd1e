package faultline.gui.window;

import faultline.gui.action.UiAction;
import faultline.gui.text.Texts;
import faultline.gui.theme.ButtonFace;
import faultline.gui.theme.TextSize;
import java.awt.Dimension;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoundedRangeModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;

/** The tool bar: what is used most. Its buttons leave the focus where it is, so that Space after a click still runs and pauses. */
final class ToolBar extends JToolBar {

    private static final int SIDE = 32;
    private static final int GROUP_GAP = 12;
    private static final int RUN_PADDING = 12;

    private final transient UiActions actions;

    ToolBar(UiActions actions, BoundedRangeModel speed) {
        this.actions = actions;
        setFloatable(false);
        addGroup("open", "save");
        addGroup("undo", "redo");
        add(runButton());
        addGroup("stepBack", "step", "restart", "record");
        JLabel label = new JLabel(Texts.text("speed"));
        SpeedSlider slider = new SpeedSlider(speed);
        label.setLabelFor(slider);
        add(label);
        add(Box.createHorizontalStrut(GROUP_GAP / 2));
        add(slider);
        add(slider.number());
        add(Box.createHorizontalStrut(GROUP_GAP));
        addGroup("fit", "path", "follow");
        add(Box.createHorizontalGlue());
        add(button(actions.get("dark")));
    }

    private void addGroup(String... keys) {
        for (String key : keys) {
            add(button(actions.get(key)));
            add(Box.createHorizontalStrut(2));
        }
        add(Box.createHorizontalStrut(GROUP_GAP));
    }

    /** A button that shows the drawing of an action. */
    static AbstractButton button(UiAction action) {
        return showing(action, action.isToggle() ? new Switch() : new Push());
    }

    /** A button that also shows whether the tool that an action takes up is in use. */
    static AbstractButton toolButton(UiAction action) {
        return showing(action, new Switch());
    }

    private static AbstractButton showing(UiAction action, AbstractButton button) {
        button.setHideActionText(true);
        button.setAction(action);
        button.getAccessibleContext().setAccessibleName(action.name());
        fix(button, 0, side());
        return button;
    }

    /** Run or Pause, wide enough for both, so that nothing jumps. */
    private AbstractButton runButton() {
        UiAction action = actions.get("run");
        JButton button = new Push();
        button.putClientProperty(ButtonFace.PRIMARY, true);
        button.updateUI();
        action.rename("pause");
        button.setAction(action);
        int width = button.getPreferredSize().width;
        action.rename("run");
        fix(button, RUN_PADDING, Math.max(width, button.getPreferredSize().width));
        return button;
    }

    /** Drawings stay as they are, so that buttons need to grow only half as much as texts. */
    private static int side() {
        return (SIDE + TextSize.scaled(SIDE)) / 2;
    }

    /** The border is no resource of the look, which tool bars would exchange for one of their own. */
    private static void fix(AbstractButton button, int padding, int width) {
        button.setFocusable(false);
        button.setBorder(BorderFactory.createEmptyBorder(0, padding, 0, padding));
        Dimension size = new Dimension(width, side());
        button.setPreferredSize(size);
        button.setMinimumSize(size);
        button.setMaximumSize(size);
    }

    /** Alt and a letter are for the menus; a button with the same letter would be in their way. */
    private static final class Push extends JButton {
        @Override
        public void setMnemonic(int mnemonic) {
            super.setMnemonic(0);
        }
    }

    /** The same for what is switched on and off. */
    private static final class Switch extends JToggleButton {
        @Override
        public void setMnemonic(int mnemonic) {
            super.setMnemonic(0);
        }
    }
}
