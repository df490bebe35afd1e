package faultline.gui.gallery;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.DefaultListModel;

/** The examples of a group that contain a text, in the order in which they were loaded. */
final class ExampleFilter {

    private final List<Example> loaded = new ArrayList<>();
    private final DefaultListModel<Example> shown = new DefaultListModel<>();
    private ExampleGroup group = ExampleGroup.ALL;
    private String wanted = "";

    /** Returns the examples that are shown. */
    DefaultListModel<Example> shown() {
        return shown;
    }

    void add(Example example) {
        loaded.add(example);
        if (matches(example)) {
            shown.addElement(example);
        }
    }

    void setGroup(ExampleGroup newGroup) {
        group = newGroup;
        update();
    }

    /** Sets the text that titles, descriptions, files or groups contain; capital letters are equal to small ones. */
    void setText(String text) {
        wanted = text.strip().toLowerCase(Locale.ROOT);
        update();
    }

    private void update() {
        List<Example> matching = loaded.stream().filter(this::matches).toList();
        shown.clear();
        shown.addAll(matching);
    }

    private boolean matches(Example example) {
        String text = String.join(
                " ",
                example.title(),
                example.description(),
                example.file(),
                ExampleGroup.of(example.file()).toString());
        return group.shows(example) && text.toLowerCase(Locale.ROOT).contains(wanted);
    }
}
