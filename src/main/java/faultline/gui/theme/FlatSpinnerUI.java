package faultline.gui.theme;

import java.awt.Component;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFormattedTextField;
import javax.swing.JSpinner;
import javax.swing.border.EmptyBorder;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicSpinnerUI;

/** A flat spinner: text and arrows share one outline. */
public final class FlatSpinnerUI extends BasicSpinnerUI {

    /** Repaints the outline when the focus changes; a text field repaints only itself. */
    private final FocusListener repainter = new FocusListener() {
        @Override
        public void focusGained(FocusEvent event) {
            spinner.repaint();
        }

        @Override
        public void focusLost(FocusEvent event) {
            spinner.repaint();
        }
    };

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatSpinnerUI();
    }

    @Override
    protected Component createNextButton() {
        JButton button = ArrowButton.up();
        button.setName("Spinner.nextButton");
        installNextButtonListeners(button);
        return button;
    }

    @Override
    protected Component createPreviousButton() {
        JButton button = ArrowButton.down();
        button.setName("Spinner.previousButton");
        installPreviousButtonListeners(button);
        return button;
    }

    @Override
    protected JComponent createEditor() {
        JComponent editor = super.createEditor();
        flatten(editor);
        return editor;
    }

    @Override
    protected void replaceEditor(JComponent before, JComponent after) {
        super.replaceEditor(before, after);
        flatten(after);
    }

    /** Removes the listener from the editor, which remains when another delegate is installed. */
    @Override
    protected void uninstallListeners() {
        if (spinner.getEditor() instanceof JSpinner.DefaultEditor numbers) {
            numbers.getTextField().removeFocusListener(repainter);
        }
        super.uninstallListeners();
    }

    private void flatten(JComponent editor) {
        if (editor instanceof JSpinner.DefaultEditor numbers) {
            JFormattedTextField text = numbers.getTextField();
            text.setBorder(new EmptyBorder(2, 5, 2, 4));
            text.setBackground(Theme.currentColours().field());
            text.removeFocusListener(repainter);
            text.addFocusListener(repainter);
        }
    }
}
