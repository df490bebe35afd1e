package faultline.gui.panel;

import faultline.gui.text.Messages;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.text.ParseException;
import java.util.function.DoubleConsumer;
import javax.swing.JButton;
import javax.swing.JFormattedTextField;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import javax.swing.SwingConstants;
import javax.swing.text.DefaultFormatterFactory;

/** A field for one number, which follows the world while the user leaves it alone. */
final class NumberSpinner extends JSpinner {

    private final transient DecimalFormatter formatter;
    private final SpinnerNumberModel model;
    private String name = "";
    private boolean updating;

    /**
     * A field for a number.
     *
     * @param pattern how it is written, see {@link java.text.DecimalFormat}
     * @param least allowed
     * @param most allowed
     * @param step of the arrows
     * @param onChange told of every number that the user gives
     */
    NumberSpinner(String pattern, double least, double most, double step, DoubleConsumer onChange) {
        formatter = new DecimalFormatter(pattern, least, most);
        model = new SpinnerNumberModel(least, least, most, step);
        setModel(model);
        JSpinner.DefaultEditor editor = new JSpinner.DefaultEditor(this);
        setEditor(editor);
        configureTextField(editor.getTextField());
        addChangeListener(event -> {
            if (!updating) {
                onChange.accept(doubleValue());
            }
        });
    }

    private void configureTextField(JFormattedTextField text) {
        text.setFormatterFactory(new DefaultFormatterFactory(formatter));
        text.setEditable(true);
        text.setHorizontalAlignment(SwingConstants.TRAILING);
        text.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                EventQueue.invokeLater(text::selectAll);
            }
        });
        // The outline, which is the spinner's, shows whether the text can be taken.
        text.addPropertyChangeListener("editValid", event -> repaint());
    }

    /** Gives a name for readers of the screen, and the limits as tool tip. */
    NumberSpinner withName(String newName) {
        name = newName;
        updateAccessibleText();
        return this;
    }

    private void updateAccessibleText() {
        getAccessibleContext().setAccessibleName(name);
        textField().getAccessibleContext().setAccessibleName(name);
        String tip = name + ": " + formatter.limitsText();
        setToolTipText(tip);
        textField().setToolTipText(tip);
        nameArrows();
    }

    private void nameArrows() {
        for (Component part : getComponents()) {
            if (part instanceof JButton arrow) {
                boolean up = "Spinner.nextButton".equals(arrow.getName());
                arrow.getAccessibleContext().setAccessibleName(Messages.get(up ? "spinner.up" : "spinner.down", name));
            }
        }
    }

    /** Sets other limits and shows a number within them, without telling anyone. */
    void setLimits(double least, double most, double value) {
        formatter.setLimits(least, most);
        model.setMinimum(least);
        model.setMaximum(most);
        setValueQuietly(value);
        updateAccessibleText();
    }

    /** Shows what is true now, unless the user is typing; the limits do not bind the truth. */
    void setWorldValue(double truth) {
        assert EventQueue.isDispatchThread();
        if (truth != doubleValue() && !isTyping()) {
            setValueQuietly(truth);
        }
    }

    /**
     * Ends the typing: takes what was typed, or drops it where it is not allowed; says whether the number is another
     * one now.
     */
    boolean commitPendingEdit() {
        double before = doubleValue();
        try {
            commitEdit();
        } catch (ParseException notAllowed) {
            textField().setValue(getValue());
        }
        return doubleValue() != before;
    }

    private void setValueQuietly(double value) {
        updating = true;
        setValue(value);
        updating = false;
    }

    private boolean isTyping() {
        return textField().isFocusOwner() && !textField().getText().equals(formatter.format(doubleValue()));
    }

    double doubleValue() {
        return model.getNumber().doubleValue();
    }

    JFormattedTextField textField() {
        return ((JSpinner.DefaultEditor) getEditor()).getTextField();
    }

    /** The widest number that fits. */
    NumberSpinner withColumns(int digits) {
        textField().setColumns(0);
        int width = getFontMetrics(getFont()).stringWidth("0".repeat(digits)) + 32;
        setPreferredSize(new Dimension(width, getPreferredSize().height));
        setMinimumSize(getPreferredSize());
        return this;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (name != null && !name.isEmpty()) {
            nameArrows();
        }
    }
}
