package faultline.gui.bar;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.SpeedScale;
import faultline.gui.action.UiAction;
import faultline.gui.text.Messages;
import faultline.gui.theme.ButtonPainter;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import java.awt.Dimension;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.BoundedRangeModel;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;
import javax.swing.UIManager;

/**
 * The tool bar with the most frequent actions. Its buttons do not take the focus, so that Space still runs and pauses
 * after a click.
 */
public final class ToolBar extends JToolBar {

    private static final int BUTTON_SIZE = 32;
    private static final int GROUP_GAP = 12;
    private static final int RUN_PADDING = 12;

    private final transient ActionRegistry actions;

    /** Creates a tool bar; {@code speed} holds positions of {@link SpeedScale}. */
    public ToolBar(ActionRegistry actions, BoundedRangeModel speed) {
        this.actions = actions;
        UiText.name(this, "toolBar");
        setFloatable(false);
        setLayout(new ToolBarLayout());
        addGroup("open", "save");
        addGroup("undo", "redo");
        add(createRunButton());
        addGroup("stepBack", "step", "restart", "record");
        add(createSpeedControl(speed));
        add(Box.createHorizontalStrut(GROUP_GAP));
        addGroup("fit", "path", "follow");
        add(createButton(actions.get("dark")));
    }

    /** Creates the slider of the speed with its name and its value, which stay in one row. */
    private static JPanel createSpeedControl(BoundedRangeModel speed) {
        JPanel control = new JPanel();
        control.setLayout(new BoxLayout(control, BoxLayout.LINE_AXIS));
        control.setOpaque(false);
        JLabel label = UiText.label("speed");
        SpeedSlider slider = new SpeedSlider(speed);
        label.setLabelFor(slider);
        control.add(label);
        control.add(Box.createHorizontalStrut(GROUP_GAP / 2));
        control.add(slider);
        control.add(slider.numberLabel());
        return control;
    }

    private void addGroup(String... keys) {
        for (String key : keys) {
            add(createButton(actions.get(key)));
            add(Box.createHorizontalStrut(2));
        }
        add(Box.createHorizontalStrut(GROUP_GAP));
    }

    /** Creates a button that shows the icon of an action. */
    private static AbstractButton createButton(UiAction action) {
        return configureButton(action, action.isToggle() ? new ToggleButton() : new PushButton());
    }

    /** Creates a button that also shows whether the tool of its action is active. */
    static AbstractButton createToolButton(UiAction action) {
        return configureButton(action, new ToggleButton());
    }

    private static AbstractButton configureButton(UiAction action, AbstractButton button) {
        button.setHideActionText(true);
        button.setAction(action);
        RefreshSteps.add(button, self -> {
            self.getAccessibleContext().setAccessibleName(action.name());
            setFixedSize(self, 0, buttonSize());
        });
        return button;
    }

    /** Creates the Run/Pause button, wide enough for both names. */
    private AbstractButton createRunButton() {
        UiAction action = actions.get("run");
        JButton button = new PushButton();
        button.putClientProperty(ButtonPainter.PRIMARY, true);
        button.updateUI();
        button.setAction(action);
        RefreshSteps.add(button, self -> setFixedSize(self, RUN_PADDING, runButtonWidth(self)));
        return button;
    }

    /** Returns the width of the Run/Pause button for the longer name. */
    private static int runButtonWidth(AbstractButton button) {
        String shown = button.getText();
        button.setPreferredSize(null);
        button.setBorder(UIManager.getBorder("Button.border"));
        int width = 0;
        for (String key : List.of("action.run", "action.pause")) {
            button.setText(Messages.get(key).replace("&", ""));
            width = Math.max(width, button.getPreferredSize().width);
        }
        button.setText(shown);
        return width;
    }

    /** Returns the size of a button. Icons do not grow with the text, so half the growth is enough. */
    private static int buttonSize() {
        return (BUTTON_SIZE + TextSize.scaled(BUTTON_SIZE)) / 2;
    }

    /** Sets a border that is not a UI resource, because a tool bar would replace it with its own. */
    private static void setFixedSize(AbstractButton button, int padding, int width) {
        button.setFocusable(false);
        button.setBorder(BorderFactory.createEmptyBorder(0, padding, 0, padding));
        Dimension size = new Dimension(width, buttonSize());
        button.setPreferredSize(size);
        button.setMinimumSize(size);
        button.setMaximumSize(size);
    }

    /** A button without a mnemonic, which would hide the menu with the same letter. */
    private static final class PushButton extends JButton {
        @Override
        public void setMnemonic(int mnemonic) {
            super.setMnemonic(0);
        }

        @Override
        public void setDisplayedMnemonicIndex(int index) {
            super.setDisplayedMnemonicIndex(-1);
        }
    }

    /** A toggle button without a mnemonic. */
    private static final class ToggleButton extends JToggleButton {
        @Override
        public void setMnemonic(int mnemonic) {
            super.setMnemonic(0);
        }

        @Override
        public void setDisplayedMnemonicIndex(int index) {
            super.setDisplayedMnemonicIndex(-1);
        }
    }
}
