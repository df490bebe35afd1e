package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Finds the files that a campaign would replace or delete in a folder without a manifest, which no campaign has
 * written. A process that was killed before it wrote the manifest has left copies of the plan's files, and a merge also
 * its tables and replays; those are not such files. A merge knows its own tables by their content, because other
 * campaigns have tables with the same columns.
 */
final class OtherFiles {

    private final CampaignFolder folder;
    private final CampaignPlan plan;
    /** The tables that an interrupted merge of this campaign has written. */
    private final Set<Path> merged;

    private OtherFiles(CampaignFolder folder, CampaignPlan plan, Set<Path> merged) {
        this.folder = folder;
        this.plan = plan;
        this.merged = merged;
    }

    /**
     * Throws an exception if there is such a file in a folder without a manifest, in which an interrupted merge of this
     * campaign has written some tables, none or all.
     */
    static void requireNone(CampaignFolder folder, CampaignPlan plan, Set<Path> merged) throws IOException {
        Optional<Path> found = new OtherFiles(folder, plan, merged).find();
        if (found.isPresent()) {
            throw new IOException(found.get() + ": the campaign would replace or delete this file,"
                    + " and the folder has no campaign.json; use another folder");
        }
    }

    private Optional<Path> find() throws IOException {
        List<Path> found = new ArrayList<>();
        Stream.of(folder.runs(), folder.timing())
                .filter(table -> Files.exists(table) && !merged.contains(table))
                .forEach(found::add);
        Stream.of(folder.plan(), folder.replays())
                .filter(inside -> Files.exists(inside) && !Files.isDirectory(inside))
                .forEach(found::add);
        for (Map.Entry<String, byte[]> copy : plan.files().copies().entrySet()) {
            Path file = folder.plan().resolve(copy.getKey());
            if (Files.exists(file) && !hasContent(file, copy.getValue())) {
                found.add(file);
            }
        }
        // A merge writes replays after this table.
        if (!merged.contains(folder.runs()) && Files.isDirectory(folder.replays())) {
            try (Stream<Path> files = Files.list(folder.replays())) {
                files.filter(WorstRuns::isReplay).sorted().findFirst().ifPresent(found::add);
            }
        }
        return found.stream().findFirst();
    }

    private static boolean hasContent(Path file, byte[] content) throws IOException {
        return Files.isRegularFile(file)
                && Files.size(file) == content.length
                && Arrays.equals(Files.readAllBytes(file), content);
    }
}
