package faultline.gui.text;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/** Calls a listener after every change of a text. */
public record TextListener(Runnable onChange) implements DocumentListener {

    @Override
    public void insertUpdate(DocumentEvent event) {
        onChange.run();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
        onChange.run();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {
        onChange.run();
    }
}
