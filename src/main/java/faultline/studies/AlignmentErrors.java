package faultline.studies;

import faultline.campaign.report.Interval;
import faultline.control.TimingRule;
import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.robot.RobotSpec;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.SortedSample;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * The distribution of the heading error with noisy sensors: 400 seeds for each rule, spin rate, control period and
 * noise. An error of more than 5 degrees is gross: the time of another edge was measured.
 */
final class AlignmentErrors implements Figure {

    static final int SEEDS = 400;
    static final double GROSS_DEGREES = 5;
    private static final int FIRST_SEED = 100_001;

    private static final String CAPTION =
            """
            Eq. (4) with noise on all sensors: the heading error at the hand-over to FOLLOW by equal readings, at \
            60\u00b0/s and a control period of 10 ms. Line: root mean square; shaded: from the 5 %% to the 95 %% \
            quantile; n\u00a0=\u00a0%d seeds at each of 1, 2, 4 and 10 mm.""";

    /** One setting; the noise in millimetres. */
    private record Setting(TimingRule rule, double degreesPerSecond, double period, double noise) {

        AlignmentTrial trial(int seed) {
            RobotSpec robot =
                    AlignmentTrial.robot(0.8, Degrees.toRadians(20), Degrees.toRadians(degreesPerSecond), 0.05);
            AlignmentTrial trial = AlignmentTrial.standard(rule, seed % 6)
                    .withRobot(SetupVariations.withNoise(robot, noise / 1000))
                    .withPeriod(period);
            return new AlignmentTrial(trial.setup().withSeed(FIRST_SEED + seed), 1);
        }

        SortedSample errors() {
            return SortedSample.of(IntStream.range(0, SEEDS)
                    .mapToObj(seed -> trial(seed).run())
                    .flatMap(result -> result.stream())
                    .mapToDouble(result -> StrictMath.toDegrees(result.headingError())));
        }
    }

    private static List<Setting> settings() {
        List<Setting> settings = new ArrayList<>();
        for (double noise : new double[] {1, 2, 4, 10}) {
            settings.add(new Setting(TimingRule.EQUAL_READINGS, 60, 0.01, noise));
        }
        settings.add(new Setting(TimingRule.EQUAL_READINGS, 60, 0.05, 4));
        settings.add(new Setting(TimingRule.EQUAL_READINGS, 60, 0.05, 10));
        settings.add(new Setting(TimingRule.RANGE, 60, 0.01, 4));
        settings.add(new Setting(TimingRule.RANGE, 60, 0.01, 10));
        for (double noise : new double[] {0, 8}) {
            settings.add(new Setting(TimingRule.RANGE, 15, 0.01, noise));
        }
        return settings;
    }

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable(
                "timing",
                "spin_rate_deg_s",
                "period_ms",
                "noise_mm",
                "n",
                "rms_deg",
                "q05_deg",
                "median_deg",
                "q95_deg",
                "max_abs_deg",
                "gross",
                "gross_share_low",
                "gross_share_high");
        List<Vector2> rms = new ArrayList<>();
        List<Vector2> high = new ArrayList<>();
        List<Vector2> low = new ArrayList<>();
        for (Setting setting : settings()) {
            SortedSample errors = setting.errors();
            addRow(table, setting, errors);
            if (setting.rule() == TimingRule.EQUAL_READINGS && setting.period() == 0.01) {
                rms.add(new Vector2(setting.noise(), errors.rms()));
                high.add(new Vector2(setting.noise(), errors.quantile(0.95)));
                low.add(new Vector2(setting.noise(), errors.quantile(0.05)));
            }
        }
        Chart chart = new Chart(
                "Heading error of equal readings with noise (n = " + SEEDS + ")",
                Axis.linear("standard deviation of the noise (mm)", 0, 10),
                Axis.linear("heading error (degrees)", -3, 3),
                List.of(
                        new Series.Band("5 % to 95 %", high, low, 0),
                        new Series.Line("", rms, 0),
                        new Series.Points("RMS", rms, 0)));
        folder.writeChart("eq4-noise-seeds", table, chart, 480, 360, String.format(Locale.ROOT, CAPTION, SEEDS));
    }

    private static void addRow(CsvTable table, Setting setting, SortedSample errors) {
        int gross = errors.countBeyond(GROSS_DEGREES);
        Interval interval = Interval.wilson(gross, errors.size());
        table.addRow(
                setting.rule().fileName(),
                setting.degreesPerSecond(),
                1000 * setting.period(),
                setting.noise(),
                errors.size(),
                errors.rms(),
                errors.quantile(0.05),
                errors.median(),
                errors.quantile(0.95),
                Math.max(-errors.min(), errors.max()),
                gross,
                interval.low(),
                interval.high());
    }
}
