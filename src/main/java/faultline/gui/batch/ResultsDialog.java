package faultline.gui.batch;

import faultline.external.ControllerChoice;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JButton;

/** Shows the results of an earlier batch or of a campaign. */
final class ResultsDialog extends RunsDialog {

    private final transient OpenedResults opened;

    /** Creates a dialog that is not yet visible, given the jars with the controllers of the runs. */
    ResultsDialog(Window owner, OpenedResults opened, List<Path> jars, BatchActions actions) {
        super(owner, actions);
        this.opened = opened;
        RefreshSteps.add(getRootPane(), root -> setTitle(Messages.get("batch.opened.title", opened.name())));
        showResults(opened.results(), new ControllerChoice("", jars));
        resultTabsOrNull().update(opened.cells());
        progress().hideBar();
        progress().showStatus(opened::status);
        JButton close = button("dialog.close", this::close);
        getRootPane().setDefaultButton(close);
        layOut(List.of(close));
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                resultTabsOrNull().focusTable();
            }
        });
    }

    /** Returns the folder of the results. */
    Path folder() {
        return opened.folder();
    }

    @Override
    void close() {
        disposeAndFocusOwner();
    }
}
