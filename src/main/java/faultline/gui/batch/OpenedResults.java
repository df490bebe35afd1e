package faultline.gui.batch;

import faultline.campaign.report.CampaignCell;
import faultline.campaign.report.CampaignTable;
import faultline.campaign.run.Outcome;
import faultline.gui.document.FileNames;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.io.Message;
import faultline.io.MessageException;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;

/**
 * The results of a batch or campaign, read from its folder, and what is shown of them. Reading is slow and safe on any
 * thread.
 *
 * @param folder the folder
 * @param table the plan and the runs
 * @param results the results for the views
 * @param cells the cells, in the order in which they are shown
 * @param broken how many runs are broken
 * @param repeats how many runs repeat another one with another seed
 */
record OpenedResults(
        Path folder, CampaignTable table, BatchResults results, List<CampaignCell> cells, long broken, long repeats) {

    /** The files of a campaign that stand for its folder. */
    private static final Set<String> FILES = Set.of("runs.csv", "campaign.json", "timing.csv");

    OpenedResults {
        cells = List.copyOf(cells);
    }

    /** Returns the folder that a chosen path means: itself, or that of a file of results. Reads the file system. */
    private static Path folderOf(Path chosen) {
        return isNamedAsFile(chosen) && Files.isRegularFile(chosen)
                ? chosen.toAbsolutePath().getParent()
                : chosen.toAbsolutePath();
    }

    private static boolean isNamedAsFile(Path chosen) {
        return FILES.contains(String.valueOf(chosen.getFileName()));
    }

    /** Returns the name of the folder that a chosen path seems to mean. */
    static String nameOf(Path chosen) {
        Path folder = chosen.toAbsolutePath();
        return FileNames.lastOf(isNamedAsFile(chosen) && folder.getParent() != null ? folder.getParent() : folder);
    }

    /**
     * Reads results.
     *
     * @param chosen their folder or one of its files
     * @throws NoSuchFileException if it has none
     * @throws IOException if they are damaged
     * @throws ScenarioException if the plan beside them is missing or wrong
     */
    static OpenedResults read(Path chosen) throws IOException, ScenarioException {
        Path folder = folderOf(chosen);
        Path runs = folder.resolve("runs.csv");
        if (!Files.exists(runs)) {
            throw new NoSuchFileException(runs.toString());
        }
        CampaignTable table = CampaignTable.read(folder);
        BatchResults results = new BatchResults(table.plan());
        table.lines().stream().skip(1).forEach(results::add);
        return new OpenedResults(
                folder,
                table,
                results,
                BatchResults.cellsOf(table.plan(), table.lines()),
                brokenCount(table.lines()),
                CampaignCell.repeatCount(table.plan(), table.lines()));
    }

    private static long brokenCount(List<List<String>> lines) {
        int outcome = lines.get(0).indexOf("outcome");
        return lines.stream()
                .filter(line -> line.get(outcome).equals(Outcome.BROKEN))
                .count();
    }

    /** Returns the name of the campaign, or that of the folder if it has none. */
    String name() {
        String name = table.plan().header().name();
        return name.isEmpty() ? FileNames.lastOf(folder) : name;
    }

    /** Returns how many runs there are, and what else there is to know. */
    String status() {
        String text = BatchProgressPanel.openedText(
                table.lines().size() - 1, table.plan().runCount(), broken, repeats);
        return table.ofThisProgram() ? text : Messages.get("batch.opened.other", text);
    }

    /** Returns the sentence that says why {@link #read} has failed. */
    static String failureText(Path chosen, Throwable failure) {
        String name = nameOf(chosen);
        return failure instanceof NoSuchFileException
                ? Messages.get("batch.opened.none", name)
                : Messages.get("batch.opened.failed", name, reason(failure));
    }

    private static String reason(Throwable failure) {
        if (failure instanceof ScenarioException bad) {
            Problem first = bad.problems().get(0);
            String reason = lastPart(first.file()) + first.location() + ": " + ErrorMessages.describe(bad);
            return mentions(first.message(), Allowed.CONTROLLERS) ? Messages.get("batch.opened.jar", reason) : reason;
        }
        if (failure instanceof MessageException file && !file.subject().isEmpty()) {
            return lastPart(file.subject()) + ": " + Messages.get(file.reason());
        }
        return ErrorMessages.describe(failure);
    }

    /** Returns the last name of a path, which line and column may follow. */
    private static String lastPart(String path) {
        return path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf(File.separatorChar)) + 1);
    }

    private static boolean mentions(Message message, Message.Template template) {
        return message.template() == template
                || message.arguments().stream()
                        .anyMatch(argument -> argument instanceof Message inner && mentions(inner, template));
    }
}
