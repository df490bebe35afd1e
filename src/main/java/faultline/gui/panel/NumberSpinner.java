package faultline.gui.panel;

import faultline.gui.text.Texts;
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

    private final transient PlainNumber number;
    private final SpinnerNumberModel model;
    private String name = "";
    private boolean following;

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
        number = new PlainNumber(pattern, least, most);
        model = new SpinnerNumberModel(least, least, most, step);
        setModel(model);
        JSpinner.DefaultEditor editor = new JSpinner.DefaultEditor(this);
        setEditor(editor);
        prepare(editor.getTextField());
        addChangeListener(event -> {
            if (!following) {
                onChange.accept(value());
            }
        });
    }

    private void prepare(JFormattedTextField text) {
        text.setFormatterFactory(new DefaultFormatterFactory(number));
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
    NumberSpinner named(String newName) {
        name = newName;
        describe();
        return this;
    }

    private void describe() {
        getAccessibleContext().setAccessibleName(name);
        text().getAccessibleContext().setAccessibleName(name);
        String tip = name + ": " + number.limits();
        setToolTipText(tip);
        text().setToolTipText(tip);
        nameArrows();
    }

    private void nameArrows() {
        for (Component part : getComponents()) {
            if (part instanceof JButton arrow) {
                boolean up = "Spinner.nextButton".equals(arrow.getName());
                arrow.getAccessibleContext().setAccessibleName(Texts.text(up ? "spinner.up" : "spinner.down", name));
            }
        }
    }

    /** Sets other limits and shows a number within them, without telling anyone. */
    void limit(double least, double most, double value) {
        number.limit(least, most);
        model.setMinimum(least);
        model.setMaximum(most);
        set(value);
        describe();
    }

    /** Shows what is true now, unless the user is typing; the limits do not bind the truth. */
    void follow(double truth) {
        assert EventQueue.isDispatchThread();
        if (truth != value() && !isTyping()) {
            set(truth);
        }
    }

    /** Ends the typing: takes what was typed, or drops it where it is not allowed; says whether the number is another one now. */
    boolean settle() {
        double before = value();
        try {
            commitEdit();
        } catch (ParseException notAllowed) {
            text().setValue(getValue());
        }
        return value() != before;
    }

    private void set(double value) {
        following = true;
        setValue(value);
        following = false;
    }

    private boolean isTyping() {
        return text().isFocusOwner() && !text().getText().equals(number.write(value()));
    }

    double value() {
        return model.getNumber().doubleValue();
    }

    JFormattedTextField text() {
        return ((JSpinner.DefaultEditor) getEditor()).getTextField();
    }

    /** The widest number that fits. */
    NumberSpinner columns(int digits) {
        text().setColumns(0);
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
