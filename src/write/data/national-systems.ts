/** A projected system: its proj4 text, and how far a place may be off on WGS 84 by its change of datum, m (EPSG). */
export type NationalSystem = readonly [name: string, proj4: string, accuracyM: number];

/**
 * National systems beside UTM, by EPSG code. From the EPSG data set: projections by epsg-index 2.0.0, changes of datum as
 * PROJ 9 takes them where it has no grid; proj4 was held against PROJ in three places of each, within a millimetre.
 */
export const NATIONAL_SYSTEMS: Readonly<Record<number, NationalSystem>> = {
  2039: [
    'Israel 1993 / Israeli TM Grid',
    '+proj=tmerc +lat_0=31.7343936111111 +lon_0=35.2045169444444 +k=1.0000067 +x_0=219529.584 +y_0=626907.39 +ellps=GRS80 +towgs84=23.772,17.49,17.859,-0.3132,-1.85274,1.67299,-5.4262',
    0.5,
  ],
  2056: [
    'CH1903+ / LV95',
    '+proj=somerc +lat_0=46.9524055555556 +lon_0=7.43958333333333 +x_0=2600000 +y_0=1200000 +ellps=bessel +towgs84=674.374,15.056,405.346,0,0,0,0',
    1,
  ],
  2100: [
    'GGRS87 / Greek Grid',
    '+proj=tmerc +lat_0=0 +lon_0=24 +k=0.9996 +x_0=500000 +y_0=0 +ellps=GRS80 +towgs84=-199.87,74.79,246.62,0,0,0,0',
    1,
  ],
  2154: [
    'RGF93 v1 / Lambert-93',
    '+proj=lcc +lat_0=46.5 +lon_0=3 +lat_1=49 +lat_2=44 +x_0=700000 +y_0=6600000 +ellps=GRS80',
    1,
  ],
  2157: [
    'IRENET95 / Irish Transverse Mercator',
    '+proj=tmerc +lat_0=53.5 +lon_0=-8 +k=0.99982 +x_0=600000 +y_0=750000 +ellps=GRS80',
    1,
  ],
  2176: [
    'ETRF2000-PL / CS2000/15',
    '+proj=tmerc +lat_0=0 +lon_0=15 +k=0.999923 +x_0=5500000 +y_0=0 +ellps=GRS80',
    1,
  ],
  2177: [
    'ETRF2000-PL / CS2000/18',
    '+proj=tmerc +lat_0=0 +lon_0=18 +k=0.999923 +x_0=6500000 +y_0=0 +ellps=GRS80',
    1,
  ],
  2178: [
    'ETRF2000-PL / CS2000/21',
    '+proj=tmerc +lat_0=0 +lon_0=21 +k=0.999923 +x_0=7500000 +y_0=0 +ellps=GRS80',
    1,
  ],
  2179: [
    'ETRF2000-PL / CS2000/24',
    '+proj=tmerc +lat_0=0 +lon_0=24 +k=0.999923 +x_0=8500000 +y_0=0 +ellps=GRS80',
    1,
  ],
  2180: [
    'ETRF2000-PL / CS92',
    '+proj=tmerc +lat_0=0 +lon_0=19 +k=0.9993 +x_0=500000 +y_0=-5300000 +ellps=GRS80',
    1,
  ],
  2193: [
    'NZGD2000 / New Zealand Transverse Mercator 2000',
    '+proj=tmerc +lat_0=0 +lon_0=173 +k=0.9996 +x_0=1600000 +y_0=10000000 +ellps=GRS80',
    1,
  ],
  2229: [
    'NAD83 / California zone 5 (ftUS)',
    '+proj=lcc +lat_0=33.5 +lon_0=-118 +lat_1=35.4666666666667 +lat_2=34.0333333333333 +x_0=2000000.0001016 +y_0=500000.0001016 +ellps=GRS80 +units=us-ft',
    4,
  ],
  2263: [
    'NAD83 / New York Long Island (ftUS)',
    '+proj=lcc +lat_0=40.1666666666667 +lon_0=-74 +lat_1=41.0333333333333 +lat_2=40.6666666666667 +x_0=300000 +y_0=0 +ellps=GRS80 +units=us-ft',
    4,
  ],
  2326: [
    'Hong Kong 1980 Grid System',
    '+proj=tmerc +lat_0=22.3121333333333 +lon_0=114.178555555556 +x_0=836694.05 +y_0=819069.8 +ellps=intl +towgs84=-162.619,-276.959,-161.764,0.067753,-2.243648,-1.158828,-1.094246',
    1,
  ],
  3003: [
    'Monte Mario / Italy zone 1',
    '+proj=tmerc +lat_0=0 +lon_0=9 +k=0.9996 +x_0=1500000 +y_0=0 +ellps=intl +towgs84=-104.1,-49.1,-9.9,0.971,-2.917,0.714,-11.68',
    4,
  ],
  3004: [
    'Monte Mario / Italy zone 2',
    '+proj=tmerc +lat_0=0 +lon_0=15 +k=0.9996 +x_0=2520000 +y_0=0 +ellps=intl +towgs84=-104.1,-49.1,-9.9,0.971,-2.917,0.714,-11.68',
    4,
  ],
  3006: ['SWEREF99 TM', '+proj=utm +zone=33 +ellps=GRS80', 1],
  3067: ['ETRS89 / TM35FIN(E,N)', '+proj=utm +zone=35 +ellps=GRS80', 1],
  3301: [
    'Estonian Coordinate System of 1997',
    '+proj=lcc +lat_0=57.5175539305556 +lon_0=24 +lat_1=59.3333333333333 +lat_2=58 +x_0=500000 +y_0=6375000 +ellps=GRS80',
    1,
  ],
  3414: [
    'SVY21 / Singapore TM',
    '+proj=tmerc +lat_0=1.36666666666667 +lon_0=103.833333333333 +x_0=28001.642 +y_0=38744.572 +ellps=WGS84',
    1,
  ],
  3763: [
    'ETRS89 / Portugal TM06',
    '+proj=tmerc +lat_0=39.6682583333333 +lon_0=-8.13310833333333 +x_0=0 +y_0=0 +ellps=GRS80',
    1,
  ],
  3765: [
    'HTRS96 / Croatia TM',
    '+proj=tmerc +lat_0=0 +lon_0=16.5 +k=0.9999 +x_0=500000 +y_0=0 +ellps=GRS80',
    1,
  ],
  3794: [
    'Slovenia 1996 / Slovene National Grid',
    '+proj=tmerc +lat_0=0 +lon_0=15 +k=0.9999 +x_0=500000 +y_0=-5000000 +ellps=GRS80',
    1,
  ],
  3812: [
    'ETRS89 / Belgian Lambert 2008',
    '+proj=lcc +lat_0=50.797815 +lon_0=4.35921583333333 +lat_1=49.8333333333333 +lat_2=51.1666666666667 +x_0=649328 +y_0=665262 +ellps=GRS80',
    1,
  ],
  3942: [
    'RGF93 v1 / CC42',
    '+proj=lcc +lat_0=42 +lon_0=3 +lat_1=41.25 +lat_2=42.75 +x_0=1700000 +y_0=1200000 +ellps=GRS80',
    1,
  ],
  3943: [
    'RGF93 v1 / CC43',
    '+proj=lcc +lat_0=43 +lon_0=3 +lat_1=42.25 +lat_2=43.75 +x_0=1700000 +y_0=2200000 +ellps=GRS80',
    1,
  ],
  3944: [
    'RGF93 v1 / CC44',
    '+proj=lcc +lat_0=44 +lon_0=3 +lat_1=43.25 +lat_2=44.75 +x_0=1700000 +y_0=3200000 +ellps=GRS80',
    1,
  ],
  3945: [
    'RGF93 v1 / CC45',
    '+proj=lcc +lat_0=45 +lon_0=3 +lat_1=44.25 +lat_2=45.75 +x_0=1700000 +y_0=4200000 +ellps=GRS80',
    1,
  ],
  3946: [
    'RGF93 v1 / CC46',
    '+proj=lcc +lat_0=46 +lon_0=3 +lat_1=45.25 +lat_2=46.75 +x_0=1700000 +y_0=5200000 +ellps=GRS80',
    1,
  ],
  3947: [
    'RGF93 v1 / CC47',
    '+proj=lcc +lat_0=47 +lon_0=3 +lat_1=46.25 +lat_2=47.75 +x_0=1700000 +y_0=6200000 +ellps=GRS80',
    1,
  ],
  3948: [
    'RGF93 v1 / CC48',
    '+proj=lcc +lat_0=48 +lon_0=3 +lat_1=47.25 +lat_2=48.75 +x_0=1700000 +y_0=7200000 +ellps=GRS80',
    1,
  ],
  3949: [
    'RGF93 v1 / CC49',
    '+proj=lcc +lat_0=49 +lon_0=3 +lat_1=48.25 +lat_2=49.75 +x_0=1700000 +y_0=8200000 +ellps=GRS80',
    1,
  ],
  3950: [
    'RGF93 v1 / CC50',
    '+proj=lcc +lat_0=50 +lon_0=3 +lat_1=49.25 +lat_2=50.75 +x_0=1700000 +y_0=9200000 +ellps=GRS80',
    1,
  ],
  4647: [
    'ETRS89 / UTM zone 32N (zE-N)',
    '+proj=tmerc +lat_0=0 +lon_0=9 +k=0.9996 +x_0=32500000 +y_0=0 +ellps=GRS80',
    1,
  ],
  5179: [
    'KGD2002 / Unified CS',
    '+proj=tmerc +lat_0=38 +lon_0=127.5 +k=0.9996 +x_0=1000000 +y_0=2000000 +ellps=GRS80',
    1,
  ],
  5514: [
    'S-JTSK / Krovak East North',
    '+proj=krovak +lat_0=49.5 +lon_0=24.8333333333333 +alpha=30.2881397527778 +k=0.9999 +x_0=0 +y_0=0 +ellps=bessel +towgs84=589,76,480,0,0,0,0',
    6,
  ],
  5650: [
    'ETRS89 / UTM zone 33N (zE-N)',
    '+proj=tmerc +lat_0=0 +lon_0=15 +k=0.9996 +x_0=33500000 +y_0=0 +ellps=GRS80',
    1,
  ],
  21781: [
    'CH1903 / LV03',
    '+proj=somerc +lat_0=46.9524055555556 +lon_0=7.43958333333333 +x_0=600000 +y_0=200000 +ellps=bessel +towgs84=674.374,15.056,405.346,0,0,0,0',
    1.5,
  ],
  23700: [
    'HD72 / EOV',
    '+proj=somerc +lat_0=47.1443937222222 +lon_0=19.0485717777778 +k_0=0.99993 +x_0=650000 +y_0=200000 +ellps=GRS67 +towgs84=52.17,-71.82,-14.9,0,0,0,0',
    1,
  ],
  25884: [
    'ETRS89 / TM Baltic93',
    '+proj=tmerc +lat_0=0 +lon_0=24 +k=0.9996 +x_0=500000 +y_0=0 +ellps=GRS80',
    1,
  ],
  27700: [
    'OSGB36 / British National Grid',
    '+proj=tmerc +lat_0=49 +lon_0=-2 +k=0.9996012717 +x_0=400000 +y_0=-100000 +ellps=airy +towgs84=446.448,-125.157,542.06,0.15,0.247,0.842,-20.489',
    2,
  ],
  28992: [
    'Amersfoort / RD New',
    '+proj=sterea +lat_0=52.1561605555556 +lon_0=5.38763888888889 +k=0.9999079 +x_0=155000 +y_0=463000 +ellps=bessel +towgs84=565.4171,50.3319,465.5524,-0.398957388243134,0.343987817378283,-1.87740163998045,4.0725',
    1,
  ],
  29902: [
    'TM65 / Irish Grid',
    '+proj=tmerc +lat_0=53.5 +lon_0=-8 +k=1.000035 +x_0=200000 +y_0=250000 +a=6377340.189 +rf=299.3249646 +towgs84=482.5,-130.6,564.6,-1.042,-0.214,-0.631,8.15',
    1,
  ],
  31254: [
    'MGI / Austria GK West',
    '+proj=tmerc +lat_0=0 +lon_0=10.3333333333333 +x_0=0 +y_0=-5000000 +ellps=bessel +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232',
    1.5,
  ],
  31255: [
    'MGI / Austria GK Central',
    '+proj=tmerc +lat_0=0 +lon_0=13.3333333333333 +x_0=0 +y_0=-5000000 +ellps=bessel +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232',
    1.5,
  ],
  31256: [
    'MGI / Austria GK East',
    '+proj=tmerc +lat_0=0 +lon_0=16.3333333333333 +x_0=0 +y_0=-5000000 +ellps=bessel +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232',
    1.5,
  ],
  31257: [
    'MGI / Austria GK M28',
    '+proj=tmerc +lat_0=0 +lon_0=10.3333333333333 +x_0=150000 +y_0=-5000000 +ellps=bessel +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232',
    1.5,
  ],
  31258: [
    'MGI / Austria GK M31',
    '+proj=tmerc +lat_0=0 +lon_0=13.3333333333333 +x_0=450000 +y_0=-5000000 +ellps=bessel +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232',
    1.5,
  ],
  31259: [
    'MGI / Austria GK M34',
    '+proj=tmerc +lat_0=0 +lon_0=16.3333333333333 +x_0=750000 +y_0=-5000000 +ellps=bessel +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232',
    1.5,
  ],
  31287: [
    'MGI / Austria Lambert',
    '+proj=lcc +lat_0=47.5 +lon_0=13.3333333333333 +lat_1=49 +lat_2=46 +x_0=400000 +y_0=400000 +ellps=bessel +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232',
    1.5,
  ],
  31370: [
    'BD72 / Belgian Lambert 72',
    '+proj=lcc +lat_0=90 +lon_0=4.36748666666667 +lat_1=51.1666672333333 +lat_2=49.8333339 +x_0=150000.013 +y_0=5400088.438 +ellps=intl +towgs84=-106.8686,52.2978,-103.7239,0.3366,-0.457,1.8422,-1.2747',
    1,
  ],
  31466: [
    'DHDN / 3-degree Gauss-Kruger zone 2',
    '+proj=tmerc +lat_0=0 +lon_0=6 +x_0=2500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7',
    3,
  ],
  31467: [
    'DHDN / 3-degree Gauss-Kruger zone 3',
    '+proj=tmerc +lat_0=0 +lon_0=9 +x_0=3500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7',
    3,
  ],
  31468: [
    'DHDN / 3-degree Gauss-Kruger zone 4',
    '+proj=tmerc +lat_0=0 +lon_0=12 +x_0=4500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7',
    3,
  ],
  31469: [
    'DHDN / 3-degree Gauss-Kruger zone 5',
    '+proj=tmerc +lat_0=0 +lon_0=15 +x_0=5500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7',
    3,
  ],
};
