package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** The number of independent observations that correlated ones are worth; expected numbers are computed by hand. */
class ClusteredSampleTest {

    private final ClusteredSample sample = new ClusteredSample();

    private void addCluster(String cluster, double... values) {
        for (double value : values) {
            sample.add(sample.size(), cluster, value);
        }
    }

    /**
     * Four clusters of ten with 8, 6, 6 and 4 ones: the mean is 0.6, the squares are 40 * 0.24 = 9.6, and the sums of
     * the clusters are 2, 0, 0 and -2. The effect is 8 * 4/3 / 9.6 = 10/9, and Student's quantile for three degrees of
     * freedom is 3.182446.
     */
    @Test
    void theDesignEffectAndItsUncertaintyMakeTheSampleSmaller() {
        addCluster("a", 1, 1, 1, 1, 1, 1, 1, 1, 0, 0);
        addCluster("b", 1, 1, 1, 1, 1, 1, 0, 0, 0, 0);
        addCluster("c", 1, 1, 1, 1, 1, 1, 0, 0, 0, 0);
        addCluster("d", 1, 1, 1, 1, 0, 0, 0, 0, 0, 0);
        double certainty = Math.pow(1.959963985 / 3.182446305, 2);
        assertEquals(36 * certainty, sample.effectiveSize(), 1e-6);
    }

    @Test
    void clustersThatAreMoreAlikeThanTheirObservationsMakeNoObservationWorthMoreThanOne() {
        for (String cluster : new String[] {"a", "b", "c"}) {
            addCluster(cluster, 1, 0, 1, 0, 1, 0, 1, 0);
        }
        assertEquals(24 * Math.pow(1.959963985 / 4.302652730, 2), sample.effectiveSize(), 1e-6);
    }

    @Test
    void clustersOfOneSizeAreWorthAtLeastOneObservationEach() {
        addCluster("a", 1, 1);
        addCluster("b", 1, 1);
        addCluster("c", 0, 0);
        assertEquals(3, sample.effectiveSize(), 1e-12);
    }

    /** If all observations of a cluster are equal, the variance is that of weights of 4/6, 1/6 and 1/6. */
    @Test
    void aGreatClusterHasAGreatWeight() {
        addCluster("a", 1, 1, 1, 1);
        addCluster("b", 0);
        addCluster("c", 0);
        assertEquals(36 / 18.0, sample.effectiveSize(), 1e-12);
    }

    @Test
    void ifNoObservationsDifferEachClusterIsWorthOne() {
        addCluster("a", 1, 1);
        addCluster("b", 1, 1, 1);
        assertEquals(2, sample.effectiveSize());
    }

    @Test
    void theObservationsOfOneClusterAreWorthOne() {
        addCluster("a", 1, 0, 1, 1);
        assertEquals(1, sample.effectiveSize());
    }

    @Test
    void singleObservationsOfClustersAreIndependent() {
        addCluster("a", 1);
        addCluster("b", 0);
        assertEquals(2, sample.effectiveSize(), 1e-12);
    }

    @Test
    void repetitionsAddOnlyWeight() {
        for (String cluster : new String[] {"a", "b", "c"}) {
            sample.add("one", cluster, 1);
        }
        assertEquals(1, sample.effectiveSize());
        assertArrayEquals(new double[] {1}, sample.clusterMeans());
        sample.add("another", "d", 0);
        assertEquals(4, sample.size());
        assertEquals(0.75, sample.mean());
        // Weights of 3/4 and 1/4.
        assertEquals(16 / 10.0, sample.effectiveSize(), 1e-12);
    }

    /** Ten clusters with one, two or three ones among their four observations. */
    private static double effectiveSizeOfTenClusters(int repetitions) {
        ClusteredSample clusters = new ClusteredSample();
        for (int cluster = 0; cluster < 10; cluster++) {
            for (int i = 0; i < 4 * repetitions; i++) {
                int observation = i % 4;
                clusters.add(cluster + " " + observation, "" + cluster, observation <= cluster % 3 ? 1 : 0);
            }
        }
        return clusters.effectiveSize();
    }

    /** The effect is 1, because the clusters are more alike than their observations. */
    @Test
    void anObservationIsWorthTheSameHoweverOftenItIsRepeated() {
        double once = effectiveSizeOfTenClusters(1);
        assertEquals(40 * Math.pow(1.959963985 / 2.262157163, 2), once, 1e-6);
        assertEquals(once, effectiveSizeOfTenClusters(3), 1e-9);
    }

    /** 50 worlds, each with ten equal runs, of which a third fails. */
    @Test
    void repetitionsOfOneObservationInEachClusterAreWorthOneObservationEach() {
        for (int i = 0; i < 500; i++) {
            int cluster = i / 10;
            sample.add(cluster, "" + cluster, cluster % 3 == 0 ? 0 : 1);
        }
        assertEquals(50, sample.effectiveSize(), 1e-9);
    }
}
