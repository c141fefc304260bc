import { readFileSync, writeFileSync } from 'node:fs';
import { asSlice, optionsWith, listeningContext } from '/work/main/tests/unit/core/boundary/wall-slices.ts';
import { findBoundary } from '/work/main/src/core/boundary.ts';
import { regulariseBoundary } from '/work/main/src/core/regularise.ts';
import { signedArea, orientRing } from '/work/main/src/core/geometry/rings.ts';
import { isSimpleRing } from '/work/main/src/core/geometry/simplicity.ts';
import { intersectD, areaPathsD, FillRule } from 'clipper2-ts';
const toPath=(r:any)=>{const p=[];for(let i=0;i<r.length;i+=2)p.push({x:r[i],y:r[i+1]});return p};
function iou(a:Float64Array,b:Float64Array){const I=Math.abs(areaPathsD(intersectD([toPath(a)] as any,[toPath(b)] as any,FillRule.NonZero,6)));return I/(Math.abs(signedArea(a))+Math.abs(signedArea(b))-I)}
export function ply(path:string){const b=readFileSync(path);const he=b.indexOf('end_header\n')+11;const head=b.subarray(0,he).toString();const n=+head.match(/vertex (\d+)/)![1];const props=[...head.matchAll(/property (\w+) (\w+)/g)].map(m=>[m[1],m[2]]);let st=0;const off:any={};for(const [t,nm] of props){off[nm]=[st,t];st+=t==='double'?8:t==='float'?4:t==='uchar'?1:t==='ushort'?2:4}
 const out=new Float64Array(3*n);for(let i=0;i<n;i++)['x','y','z'].forEach((c,k)=>{const [o,t]=off[c];out[3*i+k]=t==='double'?b.readDoubleLE(he+i*st+o):b.readFloatLE(he+i*st+o)});return out}
export function slices(name:string){
 const gt=JSON.parse(readFileSync(`/work/shared/scenes/${name}.gt.json`,'utf8'));const g=gt.storeys?gt.storeys[0]:gt;
 let P=ply(`/work/shared/scenes/${name}.ply`);const n=P.length/3;
 if(gt.up==='y'){const Q=new Float64Array(P.length);for(let i=0;i<n;i++){Q[3*i]=P[3*i];Q[3*i+1]=-P[3*i+2];Q[3*i+2]=P[3*i+1]}P=Q}
 const f=g.floor??0,h=g.height;
 const bands:any={top:[f+.78*h,f+h-.08],mid:[f+.3*h,f+.7*h],low:[f+.1,f+.3*h]};const res:any={};
 for(const k in bands){const [lo,hi]=bands[k];const pts:number[]=[];for(let i=0;i<n;i++){const z=P[3*i+2];if(z>lo&&z<hi)pts.push(P[3*i],P[3*i+1])}
  // outliers: 2D cells
  const c=.12;const m=new Map<string,number>();for(let i=0;i<pts.length;i+=2){const key=Math.floor(pts[i]/c)+','+Math.floor(pts[i+1]/c);m.set(key,(m.get(key)??0)+1)}
  const kept:number[]=[];for(let i=0;i<pts.length;i+=2){const a=Math.floor(pts[i]/c),b=Math.floor(pts[i+1]/c);let s=0;for(let u=-1;u<2;u++)for(let v=-1;v<2;v++)s+=m.get((a+u)+','+(b+v))??0;if(s>=8)kept.push(pts[i],pts[i+1])}
  let minx=1e99,maxx=-1e99,miny=1e99,maxy=-1e99;for(let i=0;i<kept.length;i+=2){minx=Math.min(minx,kept[i]);maxx=Math.max(maxx,kept[i]);miny=Math.min(miny,kept[i+1]);maxy=Math.max(maxy,kept[i+1])}
  const budget=1000*(maxx-minx)*(maxy-miny);const stride=Math.max(1,kept.length/2/budget);const xy:number[]=[];for(let i=0;i<kept.length/2;i+=stride){const j=Math.floor(i);xy.push(kept[2*j],kept[2*j+1])}
  res[k]=Float64Array.from(xy)}
 const io=g.interior_outline; const ring0=io[0]; const flat=Float64Array.from(ring0.slice(0,-1).flat());
 return {res,truth:orientRing(flat,'counter-clockwise')}}
if(process.argv[1].includes('.h_scene')){
const names=['home_rect','home_l','home_utm','home_yup','home_skew','floor_office','home_mobile','hall_round','home_open','house_two_storeys'];
const cfgs:any[]=(process.argv[2]?JSON.parse(process.argv[2]):[{}]);
const sum=cfgs.map(()=>[0,0,0,0]);
const mult=process.argv[3];
for(const nm of names){const {res,truth}=slices(nm);for(const band of ['top','mid']){const s=asSlice(res[band]);let line=nm+' '+band+' n='+s.xy.length/2+' sp='+s.spacing.toFixed(4);
 cfgs.forEach((c,ci)=>{const {om,em,ve,...cc}=c as any;const o=optionsWith({...cc,...(om?{openingLength:om*s.spacing}:{}),...(em?{epsilon:Math.max(.001,em*s.spacing)}:{})});const ctx=listeningContext();const t0=performance.now();const b=findBoundary(s,o,ctx);const t1=performance.now();const r=regulariseBoundary(b,s,o);const t2=performance.now();
  const A=b.polygons[0].outer,B=r.polygons[0].outer;const i1=iou(A,truth),i2=iou(B,truth);sum[ci][0]+=i1;sum[ci][1]+=i2;sum[ci][2]+=B.length/2;sum[ci][3]+=t2-t0;
  line+=` | ${i1.toFixed(3)} ${i2.toFixed(3)} v${A.length/2}>${B.length/2} ${(t1-t0).toFixed(0)}+${(t2-t1).toFixed(1)}ms g${b.gaps.length}${isSimpleRing(A)&&isSimpleRing(B)?'':' NOTSIMPLE'}`});
 console.log(line)}}
console.log(sum.map((s,i)=>JSON.stringify(cfgs[i])+' '+s.map(v=>(v/20).toFixed(4)).join(' ')).join('\n'));
}
