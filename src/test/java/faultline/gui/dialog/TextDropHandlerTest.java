package faultline.gui.dialog;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import javax.swing.CellRendererPane;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.TransferHandler;
import org.junit.jupiter.api.Test;

class TextDropHandlerTest {

    @Test
    void textFieldsTakeFilesAlsoThoseThatAreAddedLater() {
        runOnEdt(() -> {
            JPanel root = new JPanel();
            JTextField first = new JTextField();
            root.add(first);
            TextDropHandler.install(root, new TransferHandler("name"));
            assertInstanceOf(TextDropHandler.class, first.getTransferHandler());
            JPanel later = new JPanel();
            JTextField second = new JTextField();
            later.add(second);
            root.add(later);
            assertInstanceOf(TextDropHandler.class, second.getTransferHandler());
        });
    }

    /** Swing uses one renderer for the lists of all windows, so it would keep this one alive. */
    @Test
    void aRendererKnowsNothingOfTheWindow() {
        runOnEdt(() -> {
            JPanel root = new JPanel();
            CellRendererPane pane = new CellRendererPane();
            root.add(pane);
            TextDropHandler.install(root, new TransferHandler("name"));
            DefaultListCellRenderer renderer = new DefaultListCellRenderer();
            pane.add(renderer);
            assertEquals(0, renderer.getContainerListeners().length);
        });
    }
}
